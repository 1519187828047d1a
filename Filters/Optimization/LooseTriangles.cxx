// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LooseTriangles.h"

#include <array>
#include <cmath>
#include <iterator>

namespace stipple
{
LooseTriangles::LooseTriangles(const OptimizedMesh& mesh)
  : Mesh(mesh)
  , Triangles(mesh.triangles())
  , Chains(mesh.chains())
  , About(static_cast<std::size_t>(mesh.vertices().size()))
  , ChainsOf(About.size())
{
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    for (const int v : this->Triangles[t])
    {
      this->About[Vertex(v)].push_back(static_cast<int>(t));
    }
  }
  for (std::size_t b = 0; b < this->Chains.size(); ++b)
  {
    Chain& chain = this->Chains[b];
    for (std::size_t i = 0; i < chain.size(); ++i)
    {
      chain[i].arcLength = mesh.arcLength(chain[i]);
      this->ChainsOf[chain[i].vertex].push_back(static_cast<int>(b));
      if (i > 0)
      {
        const VertexPair edge = pairOf(chain[i - 1].vertex, chain[i].vertex);
        Keep& keep = this->Creases.try_emplace(edge, Keep::Nothing).first->second;
        keep = std::max(keep, mesh.atlas().graph().backbones[b].keep);
      }
    }
  }
}

Keep LooseTriangles::keep(Vertex a, Vertex b) const
{
  const auto found = this->Creases.find(pairOf(a, b));
  return found == this->Creases.end() ? Keep::Nothing : found->second;
}

std::vector<Vertex> LooseTriangles::ring(Vertex v) const
{
  std::vector<Vertex> result;
  for (const int t : this->About[v])
  {
    for (const int u : this->Triangles[t])
    {
      if (Vertex(u) != v)
      {
        result.push_back(Vertex(u));
      }
    }
  }
  makeUnique(result);
  return result;
}

std::vector<int> LooseTriangles::beside(Vertex a, Vertex b) const
{
  std::vector<int> result;
  std::copy_if(this->About[a].begin(), this->About[a].end(), std::back_inserter(result),
    [&](int t) { return has(this->Triangles[t], b); });
  return result;
}

std::vector<int> LooseTriangles::neighbours(int t) const
{
  std::vector<int> result;
  for (int k = 0; k < 3; ++k)
  {
    const Triangle& own = this->Triangles[t];
    for (const int other : this->beside(Vertex(own[k]), Vertex(own[(k + 1) % 3])))
    {
      if (other != t)
      {
        result.push_back(other);
      }
    }
  }
  return result;
}

int LooseTriangles::numberOfCreases(Vertex v) const
{
  const std::vector<Vertex> ring = this->ring(v);
  return static_cast<int>(
    std::count_if(ring.begin(), ring.end(), [&](Vertex u) { return this->isCrease(u, v); }));
}

bool LooseTriangles::keepsLines(Vertex v, Vertex u) const
{
  int kept = 0;
  for (const Vertex w : this->ring(v))
  {
    if (this->keep(v, w) >= Keep::Line)
    {
      return false;
    }
    kept += this->keep(v, w) == Keep::Border ? 1 : 0;
  }
  const std::vector<int> gone = this->beside(v, u);
  return kept == 0 ||
    (kept == 2 && this->keep(v, u) == Keep::Border &&
      std::all_of(gone.begin(), gone.end(), [&](int t) {
        const Vertex w = apexOf(this->Triangles[t], v, u);
        return !this->isCrease(v, w) || !this->isCrease(u, w);
      }));
}

bool LooseTriangles::isOnBoundary(Vertex v) const
{
  const std::vector<Vertex> ring = this->ring(v);
  return std::any_of(
    ring.begin(), ring.end(), [&](Vertex u) { return this->beside(u, v).size() == 1; });
}

bool LooseTriangles::mayCollapse(Vertex v, Vertex u) const
{
  const std::vector<int> gone = this->beside(v, u);
  const std::vector<Vertex> a = this->ring(v);
  const std::vector<Vertex> b = this->ring(u);
  std::vector<Vertex> common;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
  return common.size() == gone.size() &&
    std::all_of(common.begin(), common.end(), [&](Vertex w) { return this->ring(w).size() > 3; }) &&
    (gone.size() == 1 || !this->isOnBoundary(v) || !this->isOnBoundary(u));
}

void LooseTriangles::collapse(Vertex v, Vertex u)
{
  for (const Vertex w : this->ring(v))
  {
    if (const auto own = this->Creases.find(pairOf(v, w)); own != this->Creases.end())
    {
      if (w != u)
      {
        Keep& keep = this->Creases.try_emplace(pairOf(u, w), Keep::Nothing).first->second;
        keep = std::max(keep, own->second);
      }
      this->Creases.erase(pairOf(v, w));
    }
  }
  for (const int t : std::vector<int>(this->About[v]))
  {
    const bool isGone = has(this->Triangles[t], u);
    this->put(t, isGone ? Triangle{ -1, -1, -1 } : replaced(this->Triangles[t], v, u));
  }
  for (const int b : this->ChainsOf[v])
  {
    replaceIn(this->Chains[b], v, u);
    this->ChainsOf[u].push_back(b);
  }
  this->ChainsOf[v].clear();
}

void LooseTriangles::bend(Vertex p, Vertex q, Vertex v)
{
  const std::vector<OnChain> places = this->onChains(p, q, 0.5);
  const std::vector<int> pair = this->beside(p, q);
  const int own = has(this->Triangles[pair[0]], v) ? pair[0] : pair[1];
  if (pair.size() == 1)
  {
    this->put(own, { -1, -1, -1 });
  }
  else
  {
    const int other = own == pair[0] ? pair[1] : pair[0];
    const Triangle beyond = this->Triangles[other];
    this->put(own, replaced(beyond, q, v));
    this->put(other, replaced(beyond, p, v));
  }
  this->lead(p, q, places, v);
}

void LooseTriangles::lead(Vertex a, Vertex b, const std::vector<OnChain>& places, Vertex over)
{
  const Keep keep = this->keep(a, b);
  this->Creases.erase(pairOf(a, b));
  this->Creases.try_emplace(pairOf(a, over), keep);
  this->Creases.try_emplace(pairOf(over, b), keep);
  this->insert(places, over);
}

LooseTriangles::EdgeOfChain LooseTriangles::edgeAt(int c, double arcLength) const
{
  const Chain& chain = this->Chains[c];
  const double length = this->Mesh.atlas().traces()[c].length();
  const bool isClosed = this->Mesh.atlas().graph().backbones[c].closed;
  for (std::size_t i = 1; i < chain.size(); ++i)
  {
    const double begin = chain[i - 1].arcLength;
    const bool wraps = isClosed && chain[i].arcLength <= begin;
    const double end = chain[i].arcLength + (wraps ? length : 0.);
    const double there = arcLength + (wraps && arcLength < begin ? length : 0.);
    if (begin <= there && there <= end && end > begin)
    {
      return { { chain[i - 1].vertex, chain[i].vertex }, (there - begin) / (end - begin) };
    }
  }
  return {};
}

std::vector<LooseTriangles::OnChain> LooseTriangles::onChains(
  Vertex a, Vertex b, double share) const
{
  std::vector<OnChain> places;
  std::vector<int> chains = this->ChainsOf[a];
  makeUnique(chains);
  for (const int c : chains)
  {
    const Chain& chain = this->Chains[c];
    for (std::size_t i = 1; i < chain.size(); ++i)
    {
      if (pairOf(chain[i - 1].vertex, chain[i].vertex) == pairOf(a, b))
      {
        const double length = this->Mesh.atlas().traces()[c].length();
        const bool isClosed = this->Mesh.atlas().graph().backbones[c].closed;
        const double begin = chain[i - 1].arcLength;
        const double end =
          chain[i].arcLength + (isClosed && chain[i].arcLength <= begin ? length : 0.);
        const double t = chain[i].vertex == b ? share : 1. - share;
        places.push_back({ c, i, std::fmod(begin + t * (end - begin), length) });
      }
    }
  }
  return places;
}

void LooseTriangles::splitCrease(
  Vertex a, Vertex b, const std::vector<OnChain>& places, Vertex middle)
{
  this->split(a, b, middle);
  this->lead(a, b, places, middle);
}

void LooseTriangles::insert(const std::vector<OnChain>& places, Vertex v)
{
  // From behind, so that places before stay where they are.
  for (auto place = places.rbegin(); place != places.rend(); ++place)
  {
    Chain& chain = this->Chains[place->chain];
    chain.insert(chain.begin() + static_cast<std::ptrdiff_t>(place->next), { v, place->arcLength });
    this->ChainsOf[v].push_back(place->chain);
  }
}

std::vector<Vertex> LooseTriangles::obstacles(Vertex v, Vertex u) const
{
  const std::vector<Vertex> a = this->ring(v);
  const std::vector<Vertex> b = this->ring(u);
  std::vector<Vertex> result;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  const std::vector<int> gone = this->beside(v, u);
  result.erase(std::remove_if(result.begin(), result.end(),
                 [&](Vertex w) {
                   return std::any_of(
                     gone.begin(), gone.end(), [&](int t) { return has(this->Triangles[t], w); });
                 }),
    result.end());
  return result;
}

void LooseTriangles::swap(Vertex p, Vertex q)
{
  const std::vector<int> pair = this->beside(p, q);
  const Triangle first = this->Triangles[pair[0]];
  const Triangle second = this->Triangles[pair[1]];
  this->put(pair[0], replaced(first, q, apexOf(second, p, q)));
  this->put(pair[1], replaced(second, p, apexOf(first, p, q)));
}

void LooseTriangles::fan(
  const std::vector<int>& disk, const std::vector<std::array<int, 2>>& rim, Vertex middle)
{
  for (const int t : disk)
  {
    this->put(t, { -1, -1, -1 });
  }
  for (std::size_t k = 0; k < rim.size(); ++k)
  {
    if (k >= disk.size())
    {
      this->Triangles.push_back({ -1, -1, -1 });
    }
    this->put(k < disk.size() ? disk[k] : static_cast<int>(this->Triangles.size()) - 1,
      { rim[k][0], rim[k][1], middle.index() });
  }
}

void LooseTriangles::split(Vertex a, Vertex b, Vertex middle)
{
  for (const int t : this->beside(a, b))
  {
    const Triangle whole = this->Triangles[t];
    this->put(t, replaced(whole, b, middle));
    this->Triangles.push_back({ -1, -1, -1 });
    this->put(static_cast<int>(this->Triangles.size()) - 1, replaced(whole, a, middle));
  }
}

void LooseTriangles::put(int t, const Triangle& corners)
{
  for (const int v : this->Triangles[t])
  {
    if (v >= 0)
    {
      std::vector<int>& about = this->About[Vertex(v)];
      about.erase(std::find(about.begin(), about.end(), t));
    }
  }
  this->Triangles[t] = corners;
  this->Changed.push_back(t);
  for (const int v : corners)
  {
    if (v >= 0)
    {
      this->About[Vertex(v)].push_back(t);
    }
  }
}

void LooseTriangles::replaceIn(Chain& chain, Vertex v, Vertex u)
{
  Chain result;
  for (BackboneVertex at : chain)
  {
    at.vertex = at.vertex == v ? u : at.vertex;
    if (result.empty() || result.back().vertex != at.vertex)
    {
      result.push_back(at);
    }
  }
  result.back().arcLength = chain.back().arcLength;
  chain = std::move(result);
}
}
