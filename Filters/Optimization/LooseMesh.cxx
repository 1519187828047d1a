// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LooseMesh.h"

#include "Relaxation.h"
#include "TriangleDistance.h"
#include "Tuning.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace stipple
{
LooseMesh::LooseMesh(const OptimizedMesh& mesh, double tolerance)
  : Mesh(mesh)
  , Spacing(mesh)
  , Tolerance(tolerance)
  , Now(mesh)
{
  for (const Vertex v : mesh.vertices())
  {
    this->Absorbed.push_back(mesh.absorbed(v));
    this->Place.push_back(mesh.state(v));
    this->Density.push_back(mesh.density(v));
    this->IsFree.push_back(mesh.isFree(v));
  }
}

Vec3 LooseMesh::normal(const Triangle& t) const
{
  const Vec3& p = this->position(t[0]);
  return (this->position(t[1]) - p).cross(this->position(t[2]) - p);
}

double LooseMesh::angleOf(const std::array<Vec3, 3>& p)
{
  const double area = (p[1] - p[0]).cross(p[2] - p[0]).norm();
  double least = 10;
  for (int k = 0; k < 3; ++k)
  {
    const Vec3 u = p[(k + 1) % 3] - p[k];
    const Vec3 w = p[(k + 2) % 3] - p[k];
    least = std::min(least, std::atan2(area, u.dot(w)));
  }
  return least;
}

double LooseMesh::angle(const Triangle& t) const
{
  return angleOf({ { this->position(t[0]), this->position(t[1]), this->position(t[2]) } });
}

bool LooseMesh::isTurnedOver(const Triangle& before, const Triangle& after) const
{
  const Vec3 n = this->normal(after);
  Vec3 surface = Vec3::Zero();
  for (const int v : after)
  {
    surface += this->IsFree[Vertex(v)] != 0 ? this->Place[Vertex(v)].normal : Vec3::Zero();
  }
  if (surface == Vec3::Zero())
  {
    if (this->angle(before) < Tuning::LeastSoundHeight) // no telling; its neighbours will
    {
      return false;
    }
    surface = this->normal(before).normalized();
  }
  return !(n.dot(surface) > Tuning::LeastAgreement * n.norm() * surface.norm());
}

bool LooseMesh::staysOpen(Vertex v, Vertex u) const
{
  const auto leastCosine = [&](int t, bool isAfter) {
    const auto normalOf = [&](int f) {
      const Triangle& now = this->Now.triangle(f);
      return this->normal(isAfter ? replaced(now, v, u) : now).normalized();
    };
    double least = 1;
    for (const int other : this->Now.neighbours(t))
    {
      const Triangle& o = this->Now.triangle(other);
      const bool isGone = isAfter && has(o, v) && has(o, u);
      least = isGone ? least : std::min(least, normalOf(t).dot(normalOf(other)));
    }
    return least;
  };
  const std::vector<int>& about = this->Now.about(v);
  return std::all_of(about.begin(), about.end(), [&](int t) {
    const double after = has(this->Now.triangle(t), u) ? 1. : leastCosine(t, true);
    return after >= Tuning::LeastCosineOfRim || after >= leastCosine(t, false);
  });
}

PlacedTriangle LooseMesh::placed(const Triangle& t) const
{
  return { t, { this->position(t[0]), this->position(t[1]), this->position(t[2]) } };
}

BoxGrid& LooseMesh::boxes()
{
  const auto boxOf = [this](int t) {
    if (this->Now.isGone(t))
    {
      return Box{ Vec3::Zero(), Vec3::Zero() };
    }
    return this->placed(this->Now.triangle(t)).box();
  };
  const std::vector<int> changed = this->Now.takeChanges();
  if (!this->Boxes)
  {
    std::vector<Box> all;
    for (std::size_t t = 0; t < this->Now.triangles().size(); ++t)
    {
      all.push_back(boxOf(static_cast<int>(t)));
    }
    this->Boxes.emplace(std::move(all));
    return *this->Boxes;
  }
  for (const int t : changed)
  {
    if (t < this->Boxes->size())
    {
      this->Boxes->move(t, boxOf(t));
    }
    else // new ones get their first corners in their order
    {
      this->Boxes->add(boxOf(t));
    }
  }
  return *this->Boxes;
}

bool LooseMesh::isHeld(const Triangle& t) const
{
  return std::all_of(t.begin(), t.end(), [this](int v) { return this->IsFree[Vertex(v)] == 0; });
}

int LooseMesh::crossings(
  const std::vector<Triangle>& some, const std::vector<int>& leftOut, Pairs which)
{
  const auto counts = [&](const Triangle& t) { return which == Pairs::All || this->isHeld(t); };
  BoxGrid& boxes = this->boxes();
  std::vector<PlacedTriangle> own;
  int pairs = 0;
  for (const Triangle& t : some)
  {
    if (!counts(t))
    {
      continue;
    }
    const PlacedTriangle here = this->placed(t);
    boxes.forEachNear(here.box(), [&](int other) {
      const bool isWanted = !this->Now.isGone(other) && counts(this->Now.triangle(other)) &&
        std::find(leftOut.begin(), leftOut.end(), other) == leftOut.end();
      pairs += isWanted && intersect(here, this->placed(this->Now.triangle(other))) ? 1 : 0;
    });
    pairs += static_cast<int>(std::count_if(
      own.begin(), own.end(), [&](const PlacedTriangle& other) { return intersect(here, other); }));
    own.push_back(here);
  }
  return pairs;
}

bool LooseMesh::staysApart(
  const std::vector<int>& triangles, const std::vector<Triangle>& after, Pairs which)
{
  const int pairs = this->crossings(after, triangles, which);
  if (pairs == 0)
  {
    return true;
  }
  std::vector<Triangle> before;
  std::transform(triangles.begin(), triangles.end(), std::back_inserter(before),
    [this](int t) { return this->Now.triangle(t); });
  return pairs <= this->crossings(before, triangles, which);
}

bool LooseMesh::collapseStaysApart(Vertex v, Vertex u)
{
  const std::vector<int>& about = this->Now.about(v);
  std::vector<Triangle> after;
  for (const int t : about)
  {
    if (!has(this->Now.triangle(t), u))
    {
      after.push_back(replaced(this->Now.triangle(t), v, u));
    }
  }
  return this->staysApart(about, after, Pairs::Held);
}

bool LooseMesh::swapStaysApart(Vertex p, Vertex q)
{
  const std::vector<int> pair = this->Now.beside(p, q);
  const Triangle& first = this->Now.triangle(pair[0]);
  const Triangle& second = this->Now.triangle(pair[1]);
  return this->staysApart(pair,
    { replaced(first, q, apexOf(second, p, q)), replaced(second, p, apexOf(first, p, q)) },
    Pairs::Held);
}

bool LooseMesh::splitStaysApart(Vertex a, Vertex b, Vertex middle)
{
  const std::vector<int> beside = this->Now.beside(a, b);
  std::vector<Triangle> after;
  for (const int t : beside)
  {
    after.push_back(replaced(this->Now.triangle(t), a, middle));
    after.push_back(replaced(this->Now.triangle(t), b, middle));
  }
  return this->staysApart(beside, after, Pairs::All);
}

std::optional<SurfacePoint> LooseMesh::placeNear(
  const Vec3& target, const std::array<Vertex, 4>& from, double farthest) const
{
  std::optional<SurfacePoint> place;
  for (const Vertex v : from)
  {
    const SurfacePoint end = this->Mesh.walk(this->Place[v].place, target - this->position(v));
    const double distance = (end.position - target).norm();
    if (distance < farthest)
    {
      place = end;
      farthest = distance;
    }
  }
  return place;
}

void LooseMesh::collapse(Vertex v, Vertex u)
{
  const std::vector<int>& chains = this->Now.chainsOf(v);
  const bool isOnWay = chains.empty() ||
    (this->Mesh.freedom(v) != Freedom::None &&
      std::all_of(
        chains.begin(), chains.end(), [&](int b) { return this->Mesh.backbone(u) == b; }));
  if (!isOnWay) // u slides no more, if it did
  {
    this->Fixed.push_back(u);
  }
  this->Now.collapse(v, u);
  std::vector<Vec3>& absorbed = this->Absorbed[u];
  absorbed.push_back(this->position(v));
  absorbed.insert(absorbed.end(), this->Absorbed[v].begin(), this->Absorbed[v].end());
  this->Absorbed[v].clear();
  this->Freed.push_back(v);
}

Vertex LooseMesh::takeSpare(const SurfacePoint& place, bool isFree)
{
  const Vertex v = this->Freed.back();
  this->Freed.pop_back();
  this->Place[v] = place;
  this->IsFree[v] = isFree ? 1 : 0;
  return v;
}

OptimizedMesh::Change LooseMesh::finish()
{
  OptimizedMesh::Change change;
  std::size_t placed = 0;
  for (std::size_t n = 8 * this->Freed.size(); placed < this->Freed.size();)
  {
    const std::size_t before = placed;
    const std::size_t untouched = this->Now.triangles().size();
    std::vector<char> used(untouched, 0);
    for (const auto& [a, b] : this->widestEdges(n))
    {
      const auto beside = this->Now.beside(a, b);
      const bool isWhole = std::all_of(beside.begin(), beside.end(),
        [&](int t) { return t < static_cast<int>(untouched) && used[t] == 0; });
      const SurfacePoint middle = isWhole ? this->middle(a, b) : SurfacePoint();
      if (placed < this->Freed.size() && isWhole && this->isBetween(middle.position, a, b))
      {
        const Vertex v = this->Freed[placed];
        this->Place[v] = middle;
        if (this->splitStaysApart(a, b, v))
        {
          std::for_each(beside.begin(), beside.end(), [&](int t) { used[t] = 1; });
          ++placed;
          this->IsFree[v] = 1;
          this->Now.split(a, b, v);
        }
      }
    }
    if (placed == before && n >= untouched)
    {
      return {};
    }
    n = std::max(n, this->Now.triangles().size());
  }
  for (const std::vector<Vertex>* some : { &this->Freed, &this->Placed })
  {
    for (const Vertex v : *some)
    {
      change.freed.emplace_back(v, this->Place[v]);
    }
  }
  std::copy_if(this->Now.triangles().begin(), this->Now.triangles().end(),
    std::back_inserter(change.triangles), [](const Triangle& t) { return t[0] >= 0; });
  change.fixed = this->Fixed;
  change.onBackbones = std::move(this->OnBackbones);
  change.chains = this->Now.chains();
  change.absorbed = std::move(this->Absorbed);
  change.features = this->NumberOfFeatures;
  change.swaps = this->NumberOfSwaps;
  return change;
}

bool LooseMesh::freeOne()
{
  if (!this->HasLookedForSpare)
  {
    this->Spare = this->spareVertices();
    this->HasLookedForSpare = true;
  }
  while (!this->Spare.empty())
  {
    const auto [v, u] = this->Spare.back().second;
    this->Spare.pop_back();
    // What is about it may have changed.
    if (this->isInside(v) && !this->Now.beside(v, u).empty() &&
      this->angleWithout(v, u) > Tuning::SliverAngle && this->Now.mayCollapse(v, u) &&
      this->staysOpen(v, u))
    {
      this->collapse(v, u);
      this->Joined.push_back(u);
      return true;
    }
  }
  return false;
}

std::vector<std::pair<double, VertexPair>> LooseMesh::spareVertices() const
{
  std::vector<std::pair<double, VertexPair>> result;
  const int n = this->Mesh.vertices().size();
  const int step = 1 + (n - 1) / Tuning::LooksForSpare;
  for (int i = 0; i < n; i += step)
  {
    const Vertex v(i);
    double best = Tuning::SliverAngle;
    Vertex to;
    for (const Vertex u : this->isInside(v) ? this->Now.ring(v) : std::vector<Vertex>())
    {
      const double worst = this->angleWithout(v, u);
      if (worst > best)
      {
        best = worst;
        to = u;
      }
    }
    if (to.valid())
    {
      result.push_back({ best, { v, to } });
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

bool LooseMesh::isInside(Vertex v) const
{
  const std::vector<Vertex> ring = this->Now.ring(v);
  return !ring.empty() && this->Mesh.isFree(v) && this->IsFree[v] != 0 &&
    this->Mesh.fineness(v) == 1. &&
    std::all_of(ring.begin(), ring.end(), [&](Vertex u) { return this->IsFree[u] != 0; }) &&
    !this->Now.isOnBoundary(v);
}

double LooseMesh::distanceToRest(const Vec3& p, Vertex v, Vertex u) const
{
  double least = (p - this->position(u)).norm();
  for (const int t : this->Now.about(v))
  {
    if (!has(this->Now.triangle(t), u))
    {
      const auto [i, j, k] = replaced(this->Now.triangle(t), v, u);
      least = std::min(least,
        std::sqrt(
          squaredDistanceToTriangle(p, this->position(i), this->position(j), this->position(k))));
    }
  }
  return least;
}

double LooseMesh::angleWithout(Vertex v, Vertex u) const
{
  double worst = 10;
  for (const int t : this->Now.about(v))
  {
    const Triangle& before = this->Now.triangle(t);
    const Triangle after = replaced(before, v, u);
    worst = has(before, u)                ? worst
      : this->isTurnedOver(before, after) ? -1.
                                          : std::min(worst, this->angle(after));
  }
  return worst -
    Tuning::PoorFeatureAngle * this->distanceToRest(this->position(v), v, u) / this->spacingAt(v);
}

double LooseMesh::areaOf(const Triangle& t) const
{
  double density = 0;
  for (const int v : t)
  {
    density += this->Density[Vertex(v)];
  }
  return density * this->normal(t).norm();
}

std::vector<VertexPair> LooseMesh::widestEdges(std::size_t numberOfTriangles) const
{
  std::vector<std::pair<double, int>> largest;
  for (std::size_t t = 0; t < this->Now.triangles().size(); ++t)
  {
    if (!this->Now.isGone(static_cast<int>(t)))
    {
      largest.emplace_back(-this->areaOf(this->Now.triangles()[t]), static_cast<int>(t));
    }
  }
  const std::size_t n = std::min(largest.size(), numberOfTriangles);
  std::partial_sort(
    largest.begin(), largest.begin() + static_cast<std::ptrdiff_t>(n), largest.end());
  largest.resize(n);
  std::vector<std::pair<double, VertexPair>> edges;
  for (const auto& [area, t] : largest)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Vertex a(this->Now.triangle(t)[k]);
      const Vertex b(this->Now.triangle(t)[(k + 1) % 3]);
      const auto beside = this->Now.beside(a, b);
      if (beside.size() == 2 && !this->Now.isCrease(a, b) &&
        (this->IsFree[a] != 0 || this->IsFree[b] != 0))
      {
        edges.emplace_back(-this->areaOf(this->Now.triangle(beside[0])) -
            this->areaOf(this->Now.triangle(beside[1])),
          pairOf(a, b));
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<VertexPair> result;
  for (const auto& [area, edge] : edges)
  {
    if (result.empty() || result.back() != edge) // some were met from both sides
    {
      result.push_back(edge);
    }
  }
  return result;
}

SurfacePoint LooseMesh::middle(Vertex a, Vertex b) const
{
  const auto halfWay = [this](Vertex from, Vertex to) {
    return this->Mesh.walk(
      this->Place[from].place, 0.5 * (this->position(to) - this->position(from)));
  };
  const Vertex from = this->IsFree[a] != 0 ? a : b;
  const Vertex to = from == a ? b : a;
  const SurfacePoint result = halfWay(from, to);
  return this->IsFree[to] == 0 || this->isBetween(result.position, a, b) ? result
                                                                         : halfWay(to, from);
}

bool LooseMesh::isBetween(const Vec3& place, Vertex a, Vertex b) const
{
  return std::min((place - this->position(a)).norm(), (place - this->position(b)).norm()) >=
    Tuning::FarthestOffEdge * this->length(a, b);
}
}
