// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RibSearch.h"

#include "EdgeSwaps.h"
#include "LocalRepair.h"
#include "MeshRegion.h"
#include "Relaxation.h"
#include "Tuning.h"
#include "VertexStar.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <queue>
#include <unordered_set>
#include <utility>

namespace stipple
{
namespace
{
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
  return beyond < 0 ? 0 : Tuning::RibWeight + 4 * beyond * beyond;
}

/// How swapping an edge changes the cost of its four vertices.
int changeOfCost(const OptimizedMesh& mesh, Edge e)
{
  return costChangeOfSwap(
    mesh, e, [&](Halfedge h) { return ribExcess(mesh, h); },
    [&](Vertex v, int excess) { return costOf(mesh.freedom(v) == Freedom::Backbone, excess); });
}

/// Whether swaps that do not meet one demand may meet the other.
bool isLess(const RibDemand& a, const RibDemand& b)
{
  return a.minimumAngle < b.minimumAngle || a.bound.faces > b.bound.faces ||
    a.bound.creases > b.bound.creases;
}

/// A number for the edge and the one that it would be swapped for.
std::uint64_t outcomeOf(const OptimizedMesh& mesh, Edge e)
{
  const auto numberOf = [](Vertex p, Vertex q) {
    const auto a = static_cast<std::uint64_t>(p.index());
    const auto b = static_cast<std::uint64_t>(q.index());
    // splitmix64's way of mixing
    std::uint64_t x = (std::min(a, b) << 32 | std::max(a, b)) + 0x9e3779b97f4a7c15u;
    x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9u;
    x = (x ^ x >> 27) * 0x94d049bb133111ebu;
    return x ^ x >> 31;
  };
  const auto v = mesh.wingVertices(e);
  return numberOf(v[0], v[1]) ^ numberOf(v[2], v[3]);
}

/// Least cosine between neighbours of which one touches nothing but creases, so that its quality
/// does not tell folds.
double worstBend(const OptimizedMesh& mesh, const std::vector<Face>& faces)
{
  double worst = 1;
  for (const Face f : faces)
  {
    const auto t = mesh.corners(f);
    if (std::any_of(t.begin(), t.end(), [&](Vertex v) { return mesh.isFree(v); }))
    {
      continue;
    }
    const Halfedge h = mesh.halfedge(f);
    for (const Halfedge g : { h, mesh.next(h), mesh.previous(h) })
    {
      if (mesh.isSwappable(mesh.edge(g)))
      {
        worst =
          std::min(worst, mesh.faceNormal(f).dot(mesh.faceNormal(mesh.face(mesh.opposite(g)))));
      }
    }
  }
  return worst;
}

/// Of its neighbours on the crease.
void slideToMiddle(MeshEdit& edit, Vertex v)
{
  const OptimizedMesh& mesh = edit.mesh();
  const auto unevenness = [&]() {
    std::vector<double> length;
    mesh.forEachHalfedge(v, [&](Halfedge h) {
      if (mesh.isCrease(mesh.edge(h)))
      {
        length.push_back((mesh.position(mesh.to(h)) - mesh.position(v)).norm());
      }
    });
    return length.size() == 2 ? std::abs(length[1] - length[0]) : 0.;
  };
  const double before = unevenness();
  const auto isBetter = [&]() { return unevenness() < before; };
  edit.trySlide(v, 0.5 * before, isBetter) || edit.trySlide(v, -0.5 * before, isBetter);
}

void flipAll(MeshEdit& edit, const std::vector<Edge>& edges)
{
  for (const Edge e : edges)
  {
    edit.flip(e);
  }
}

/// Every vertex to the middle of its neighbours.
void spread(MeshEdit& edit, const std::vector<Vertex>& vertices)
{
  for (int round = 0; round < Tuning::SpreadingRounds; ++round)
  {
    for (const Vertex v : vertices)
    {
      if (edit.mesh().isFree(v))
      {
        edit.put(v, edit.mesh().walk(edit.mesh().place(v), stepToMiddle(edit.mesh(), v)));
      }
      else
      {
        slideToMiddle(edit, v);
      }
    }
  }
}
}

RibSearch::RibSearch(MeshEdit& edit, const SurfaceProximity& proximity, int budget)
  : Edit(edit)
  , Mesh(edit.mesh())
  , Proximity(proximity)
  , Budget(budget)
  , LastChange(static_cast<std::size_t>(edit.mesh().vertices().size()), 0)
  , Seen(LastChange)
{
}

bool RibSearch::mend(Halfedge h, const RibDemand& demand)
{
  if (ribExcess(this->Mesh, h) == 0 || this->Budget <= 0)
  {
    return false;
  }
  const auto found = this->Memory.find(h);
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
      [&](const std::vector<Edge>& edges) { return this->swapAndSettle(edges, demand); });
  }
  return mended;
}

bool RibSearch::hasChanged(const Attempt& attempt) const
{
  return std::any_of(attempt.vertices.begin(), attempt.vertices.end(),
    [&](Vertex v) { return this->LastChange[v] > attempt.time; });
}

bool RibSearch::search(Halfedge h, const RibDemand& demand)
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
  for (int count = 0; !queue.empty() && count < demand.sequences; ++count)
  {
    --this->Budget;
    const int index = queue.top().second;
    queue.pop();
    const std::vector<Edge> done = this->edgesOf(sequences, index);
    std::vector<Sequence> longer;
    this->Edit.attempt([&]() {
      flipAll(this->Edit, done);
      std::vector<Edge> edges;
      done.empty() ? this->addHelpfulSwaps(h, edges) : this->addSwapsAfter(done, edges);
      for (const Edge e : edges)
      {
        this->note(e, attempt);
        const std::uint64_t outcome = sequences[index].outcome ^ outcomeOf(this->Mesh, e);
        if (known.count(outcome) == 0 && this->Mesh.keepsManifold(e))
        {
          known.insert(outcome);
          longer.push_back({ index, e, sequences[index].length + 1,
            sequences[index].change + changeOfCost(this->Mesh, e), outcome });
        }
      }
      return false; // it was but a look
    });
    for (const Sequence& next : longer)
    {
      if (next.change < 0 && static_cast<int>(attempt.candidates.size()) < demand.trials)
      {
        attempt.candidates.push_back(done);
        attempt.candidates.back().push_back(next.edge);
        if (this->swapAndSettle(attempt.candidates.back(), demand))
        {
          return true;
        }
        // Two flips exchange an edge's triangles: as often as ever.
        this->Edit.attempt([&]() {
          flipAll(this->Edit, done);
          return false;
        });
      }
      if (next.length < Tuning::LongestSequence)
      {
        queue.push({ next.change + next.length, static_cast<int>(sequences.size()) });
        sequences.push_back(next);
      }
    }
  }
  this->Memory[h] = std::move(attempt);
  return false;
}

std::vector<Edge> RibSearch::edgesOf(const std::vector<Sequence>& sequences, int index) const
{
  std::vector<Edge> edges;
  for (int i = index; i > 0; i = sequences[i].base)
  {
    edges.push_back(sequences[i].edge);
  }
  std::reverse(edges.begin(), edges.end());
  return edges;
}

/// That a search depends on the vertices about an edge.
void RibSearch::note(Edge e, Attempt& attempt)
{
  for (const Vertex v : this->Mesh.wingVertices(e))
  {
    if (this->Seen[v] != this->Searches)
    {
      this->Seen[v] = this->Searches;
      attempt.vertices.push_back(v);
    }
  }
}

/// Turns h clockwise to the crease that its side begins at.
Halfedge RibSearch::beginOfSide(Halfedge h) const
{
  while (!this->isWall(h))
  {
    h = this->Mesh.next(this->Mesh.opposite(h));
  }
  return h;
}

/// The edges that meet at the vertex of h on the side that h begins (at an inner vertex, all of
/// them), or those opposite to it there.
void RibSearch::addEdges(Halfedge h, bool opposite, std::vector<Edge>& edges) const
{
  const Halfedge first = h;
  do
  {
    const Halfedge last = this->Mesh.previous(h);
    const Halfedge added = opposite ? this->Mesh.next(h) : last;
    if (!this->isWall(added))
    {
      edges.push_back(this->Mesh.edge(added));
    }
    h = this->Mesh.opposite(last);
  } while (h != first && !this->isWall(h));
}

/// Edges whose swap brings the side that h begins nearer to two neighbours, or gives a neighbour
/// on the crease one that it can hand on; or brings an inner vertex nearer to six.
void RibSearch::addHelpfulSwaps(Halfedge h, std::vector<Edge>& edges) const
{
  const bool isInner = this->Mesh.freedom(this->Mesh.from(h)) != Freedom::Backbone;
  const int excess = ribExcess(this->Mesh, h);
  if (std::abs(excess) <= (isInner ? Tuning::InnerExcess : 0))
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
      const Halfedge g = this->Mesh.halfedge(edges[i], side);
      if (this->Mesh.freedom(this->Mesh.from(g)) == Freedom::Backbone)
      {
        this->addEdges(this->beginOfSide(g), true, edges);
      }
    }
  }
}

/// Helpful swaps at the sides and inner vertices that a sequence of swaps has changed.
void RibSearch::addSwapsAfter(const std::vector<Edge>& sequence, std::vector<Edge>& edges) const
{
  std::vector<Halfedge> sides;
  for (const Edge e : sequence)
  {
    for (const Halfedge h : this->Mesh.wing(e))
    {
      const Vertex v = this->Mesh.from(h);
      if (this->Mesh.freedom(v) != Freedom::None)
      {
        sides.push_back(this->Mesh.isFree(v) ? this->Mesh.halfedge(v) : this->beginOfSide(h));
      }
    }
  }
  makeUnique(sides);
  for (const Halfedge side : sides)
  {
    this->addHelpfulSwaps(side, edges);
  }
  makeUnique(edges);
}

/// Swaps edges and moves vertices, on creases along them, until all triangles are as good as asked
/// for, or as good as the worst of them was, none is folded over and all are near the surface; else
/// nothing is changed.
bool RibSearch::swapAndSettle(const std::vector<Edge>& edges, const RibDemand& demand)
{
  std::vector<Vertex> inner; // that the swaps change edges of
  for (const Edge e : edges)
  {
    const auto quad = this->Mesh.wingVertices(e);
    inner.insert(inner.end(), quad.begin(), quad.end());
  }
  const std::vector<Vertex> all = withRings(this->Mesh, inner, 1);
  const std::vector<Face> faces = facesAbout(this->Mesh, all);
  const std::vector<Vertex> movable =
    filtered(all, [this](Vertex v) { return this->Mesh.freedom(v) != Freedom::None; });
  const double wanted = std::min(demand.minimumAngle, worstQuality(this->Mesh, faces));
  const double bend = std::min(Tuning::LeastBend, worstBend(this->Mesh, faces));
  int moves = 0;
  const auto settleHere = [&]() {
    return settle(
      this->Edit, movable, faces, demand.minimumAngle, wanted, Tuning::RibSettling, &moves);
  };
  const auto settleSpread = [&]() {
    spread(this->Edit, movable);
    return settleHere();
  };
  const bool isKept = wanted >= Tuning::HopelessAngle && this->Edit.attempt([&]() {
    flipAll(this->Edit, edges);
    return (this->Edit.attempt(settleHere) || this->Edit.attempt(settleSpread)) &&
      worstBend(this->Mesh, faces) >= bend && this->Proximity.isNear(faces, demand.bound);
  });
  this->Budget -= Tuning::TrialCost + moves / Tuning::MovesPerSequence;
  if (isKept)
  {
    ++this->Time;
    const auto note = [this](Vertex v) { this->LastChange[v] = this->Time; };
    std::for_each(inner.begin(), inner.end(), note);
    std::for_each(movable.begin(), movable.end(), note);
    this->Moved.insert(this->Moved.end(), movable.begin(), movable.end());
  }
  return isKept;
}
}
