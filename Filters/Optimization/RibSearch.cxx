// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RibSearch.h"

#include "EdgeSwaps.h"
#include "SwapTrial.h"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <queue>
#include <unordered_set>
#include <utility>

namespace stipple
{
namespace
{
using HalfedgeHandle = OptimizedMesh::Halfedge;

/// What a side with other than two neighbours weighs against irregular vertices elsewhere.
constexpr int RibWeight = 8;
/// Swaps in a row when neighbours are handed on.
constexpr int LongestSequence = 40;
/// Inner vertices are helped, too, whose valence is off by more than this.
constexpr int LargestInnerExcess = 2;
/// What a trial takes of the budget: the time of so many sequences that are looked at.
constexpr int TrialCost = 20;

/// A second neighbour too many at a side costs little more than one: else faults could not be
/// handed on past each other, where creases are an edge apart, or be two at one vertex for one at
/// each of two.
int costOf(bool onCrease, int excess)
{
  if (!onCrease)
  {
    return irregularity(excess);
  }
  const int beyond = std::abs(excess) - 1;
  return beyond < 0 ? 0 : RibWeight + 4 * beyond * beyond;
}

/// How swapping an edge changes the cost of its four vertices.
int changeOfCost(const OptimizedMesh& mesh, int edge)
{
  const std::array<HalfedgeHandle, 4> corner = cornersAbout(mesh, edge);
  int change = 0;
  for (int i = 0; i < 4; ++i)
  {
    const int v = mesh.graph().from_vertex_handle(corner[i]).idx();
    const bool onCrease = mesh.freedom(v) == Freedom::Backbone;
    const int before = ribExcess(mesh, corner[i]);
    change += costOf(onCrease, before + (i < 2 ? -1 : 1)) - costOf(onCrease, before);
  }
  return change;
}

/// Whether swaps that do not meet one demand may meet the other.
bool isLess(const RibDemand& a, const RibDemand& b)
{
  return a.minimumAngle < b.minimumAngle || a.reach.faces > b.reach.faces ||
    a.reach.creases > b.reach.creases;
}

/// A number for the edge and the one that it would be swapped for.
std::uint64_t outcomeOf(const OptimizedMesh& mesh, int edge)
{
  const auto numberOf = [](std::uint64_t a, std::uint64_t b) {
    // splitmix64's way of mixing
    std::uint64_t x = (std::min(a, b) << 32 | std::max(a, b)) + 0x9e3779b97f4a7c15u;
    x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9u;
    x = (x ^ x >> 27) * 0x94d049bb133111ebu;
    return x ^ x >> 31;
  };
  std::array<int, 4> v;
  const std::array<HalfedgeHandle, 4> corner = cornersAbout(mesh, edge);
  std::transform(corner.begin(), corner.end(), v.begin(),
    [&](HalfedgeHandle h) { return mesh.graph().from_vertex_handle(h).idx(); });
  return numberOf(v[0], v[1]) ^ numberOf(v[2], v[3]);
}
}

RibSearch::RibSearch(OptimizedMesh& mesh, const SurfaceProximity& proximity, int budget)
  : Mesh(mesh)
  , Proximity(proximity)
  , Budget(budget)
  , LastChange(mesh.numberOfVertices(), 0)
  , Seen(mesh.numberOfVertices(), 0)
{
}

bool RibSearch::mend(HalfedgeHandle h, const RibDemand& demand)
{
  const bool isFree = demand.sequences == 1;
  if (ribExcess(this->Mesh, h) == 0 || (!isFree && this->Budget <= 0))
  {
    return false;
  }
  const int before = this->Budget;
  const auto found = this->Memory.find(h.idx());
  bool mended = false;
  if (found == this->Memory.end() || found->second.demand.sequences < demand.sequences ||
    this->hasChanged(found->second))
  {
    mended = this->search(h, demand);
  }
  else if (isLess(demand, found->second.demand))
  {
    Attempt& attempt = found->second;
    attempt.demand = demand;
    mended = std::any_of(attempt.candidates.begin(), attempt.candidates.end(),
      [&](const std::vector<int>& edges) { return this->settles(edges, demand); });
  }
  if (isFree)
  {
    this->Budget = before;
  }
  return mended;
}

bool RibSearch::hasChanged(const Attempt& attempt) const
{
  return std::any_of(attempt.vertices.begin(), attempt.vertices.end(),
    [&](int v) { return this->LastChange[v] > attempt.time; });
}

bool RibSearch::search(HalfedgeHandle h, const RibDemand& demand)
{
  Attempt attempt;
  attempt.time = this->Time;
  attempt.demand = demand;
  ++this->Searches;
  using Entry = std::pair<int, int>; // a sequence's priority, and its index
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  std::vector<Sequence> sequences(1);
  std::unordered_set<std::uint64_t> known = { 0 };
  queue.push({ 0, 0 });
  std::vector<int> edges;
  for (int count = 0; !queue.empty() && count < demand.sequences; ++count)
  {
    --this->Budget;
    const int index = queue.top().second;
    queue.pop();
    const Sequence base = sequences[index];
    const std::vector<int> done = this->edgesOf(sequences, index);
    swapAll(this->Mesh, done);
    edges.clear();
    if (done.empty())
    {
      this->addHelpfulSwaps(h, edges);
    }
    else
    {
      this->addSwapsAfter(done, edges);
    }
    for (int edge : edges)
    {
      this->note(edge, attempt);
      const std::uint64_t outcome = base.outcome ^ outcomeOf(this->Mesh, edge);
      if (known.count(outcome) > 0 || !this->Mesh.graph().is_flip_ok(OpenMesh::EdgeHandle(edge)))
      {
        continue;
      }
      known.insert(outcome);
      const Sequence next = { index, edge, base.length + 1,
        base.change + changeOfCost(this->Mesh, edge), outcome };
      if (next.change < 0 && static_cast<int>(attempt.candidates.size()) < demand.trials)
      {
        swapBack(this->Mesh, done);
        attempt.candidates.push_back(done);
        attempt.candidates.back().push_back(edge);
        if (this->settles(attempt.candidates.back(), demand))
        {
          return true;
        }
        swapAll(this->Mesh, done);
      }
      if (next.length < LongestSequence)
      {
        queue.push({ next.change + next.length, static_cast<int>(sequences.size()) });
        sequences.push_back(next);
      }
    }
    swapBack(this->Mesh, done);
  }
  this->Memory[h.idx()] = std::move(attempt);
  return false;
}

std::vector<int> RibSearch::edgesOf(const std::vector<Sequence>& sequences, int index) const
{
  std::vector<int> edges;
  for (int i = index; i > 0; i = sequences[i].base)
  {
    edges.push_back(sequences[i].edge);
  }
  std::reverse(edges.begin(), edges.end());
  return edges;
}

/// That a search depends on the vertices about an edge.
void RibSearch::note(int edge, Attempt& attempt)
{
  for (const HalfedgeHandle h : cornersAbout(this->Mesh, edge))
  {
    const int v = this->Mesh.graph().from_vertex_handle(h).idx();
    if (this->Seen[v] != this->Searches)
    {
      this->Seen[v] = this->Searches;
      attempt.vertices.push_back(v);
    }
  }
}

bool RibSearch::isWall(HalfedgeHandle h) const
{
  return !this->Mesh.isSwappable(this->Mesh.graph().edge_handle(h).idx());
}

/// Turns h clockwise to the crease that its side begins at.
HalfedgeHandle RibSearch::beginOfSide(HalfedgeHandle h) const
{
  while (!this->isWall(h))
  {
    h = this->Mesh.graph().next_halfedge_handle(this->Mesh.graph().opposite_halfedge_handle(h));
  }
  return h;
}

/// The edges that meet at the vertex of h on the side that h begins (at an inner vertex, all of
/// them), or those opposite to it there.
void RibSearch::addEdges(HalfedgeHandle h, bool opposite, std::vector<int>& edges) const
{
  const auto& graph = this->Mesh.graph();
  const HalfedgeHandle first = h;
  do
  {
    const HalfedgeHandle last = graph.prev_halfedge_handle(h);
    const HalfedgeHandle edge = opposite ? graph.next_halfedge_handle(h) : last;
    if (!this->isWall(edge))
    {
      edges.push_back(graph.edge_handle(edge).idx());
    }
    h = graph.opposite_halfedge_handle(last);
  } while (h != first && !this->isWall(h));
}

/// Edges whose swap brings the side that h begins nearer to two neighbours, or gives a neighbour
/// on the crease one that it can hand on; or brings an inner vertex nearer to six.
void RibSearch::addHelpfulSwaps(HalfedgeHandle h, std::vector<int>& edges) const
{
  const auto& graph = this->Mesh.graph();
  const bool isInner = this->Mesh.freedom(graph.from_vertex_handle(h).idx()) != Freedom::Backbone;
  const int excess = ribExcess(this->Mesh, h);
  if (std::abs(excess) <= (isInner ? LargestInnerExcess : 0))
  {
    return;
  }
  const std::size_t begin = edges.size();
  this->addEdges(h, excess < 0, edges);
  if (excess > 0 || isInner)
  {
    return;
  }
  // The ends of the edges opposite to it that lie on the same crease come first and last.
  const std::size_t end = edges.size();
  for (std::size_t i = begin; i < end; ++i)
  {
    for (int side = 0; side < 2; ++side)
    {
      const HalfedgeHandle g = graph.halfedge_handle(OpenMesh::EdgeHandle(edges[i]), side);
      if (this->Mesh.freedom(graph.from_vertex_handle(g).idx()) == Freedom::Backbone)
      {
        this->addEdges(this->beginOfSide(g), true, edges);
      }
    }
  }
}

/// Helpful swaps at the sides and inner vertices that a sequence of swaps has changed.
void RibSearch::addSwapsAfter(const std::vector<int>& sequence, std::vector<int>& edges) const
{
  std::vector<int> sides;
  for (int edge : sequence)
  {
    for (const HalfedgeHandle h : cornersAbout(this->Mesh, edge))
    {
      const OptimizedMesh::Vertex v = this->Mesh.graph().from_vertex_handle(h);
      const Freedom freedom = this->Mesh.freedom(v.idx());
      if (freedom == Freedom::Backbone)
      {
        sides.push_back(this->beginOfSide(h).idx());
      }
      else if (freedom == Freedom::Surface)
      {
        sides.push_back(this->Mesh.graph().halfedge_handle(v).idx());
      }
    }
  }
  makeUnique(sides);
  for (int side : sides)
  {
    this->addHelpfulSwaps(HalfedgeHandle(side), edges);
  }
  makeUnique(edges);
}

bool RibSearch::settles(const std::vector<int>& edges, const RibDemand& demand)
{
  this->Budget -= TrialCost;
  SwapTrial trial(this->Mesh, edges);
  if (!trial.settle(demand.minimumAngle) || !this->Proximity.isNear(trial.faces(), demand.reach))
  {
    trial.takeBack();
    return false;
  }
  ++this->Time;
  for (const std::vector<int>* changed : { &trial.inner(), &trial.vertices() })
  {
    for (int v : *changed)
    {
      this->LastChange[v] = this->Time;
    }
  }
  this->Moved.insert(this->Moved.end(), trial.vertices().begin(), trial.vertices().end());
  return true;
}
}
