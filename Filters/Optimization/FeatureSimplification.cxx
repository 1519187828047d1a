// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureSimplification.h"

#include "LooseMesh.h"
#include "Relaxation.h"
#include "SurfaceError.h"
#include "Tuning.h"
#include "VertexStar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

namespace stipple
{
namespace
{
class Simplification : public LooseMesh
{
public:
  Simplification(const OptimizedMesh& mesh, double tolerance)
    : LooseMesh(mesh, tolerance)
  {
  }

  /// Opens a triangle that the mesh had, if it is still there and poor: its shortest edge goes, or
  /// its longest runs over the third corner, or edges that are in the way of that are swapped.
  /// Where nothing of it can be done and the triangle is as good as none, that corner goes along
  /// one of the shorter edges however long they are, or a vertex from elsewhere opens it.
  void improve(int triangle)
  {
    if (this->Now.isGone(triangle) ||
      this->angle(this->Now.triangle(triangle)) >= Tuning::PoorFeatureAngle)
    {
      return;
    }
    // a and b at the shortest edge; c and the farther one of them at the longest
    Triangle t = this->Now.triangle(triangle);
    const auto length = [&](int k) { return this->length(Vertex(t[k]), Vertex(t[(k + 1) % 3])); };
    while (length(0) > length(1) || length(0) > length(2))
    {
      std::rotate(t.begin(), t.begin() + 1, t.end());
    }
    const Vertex a(t[0]);
    const Vertex b(t[1]);
    const Vertex c(t[2]);
    const bool isNear = length(0) <= std::min(this->spacingAt(a), this->spacingAt(b));
    const Vertex middle = length(1) > length(2) ? a : b; // between the shorter edges
    const Vertex end = middle == a ? b : a;
    const bool isDone = (isNear && this->collapseOneOf({ { a, b }, { b, a } })) ||
      this->bend(end, c, middle) || this->swapOver(end, c, middle) ||
      (isNear && (this->collapseAfterSwaps(a, b) || this->collapseAfterSwaps(b, a)));
    if (!isDone && this->angle(t) < Tuning::HopelessAngle)
    {
      const std::array<VertexPair, 4> ways = { { { middle, end }, { middle, c }, { end, middle },
        { c, middle } } };
      this->collapseOneOf({ ways.begin(), ways.end() }) ||
        std::any_of(ways.begin(), ways.end(),
          [this](
            const VertexPair& way) { return this->collapseAfterSwaps(way.first, way.second); }) ||
        (this->angle(t) < Tuning::NoAngle && this->openWithVertex(end, c, middle));
    }
  }

  /// The longest edge of a poor triangle gets a vertex that is needed less elsewhere, as in
  /// Delaunay refinement (Ruppert 1995), where nothing simpler helped: an edge of creases, or
  /// between two. So long an edge that its halves are closer to the spacing, or as close (Botsch
  /// and Kobbelt 2004); so this ends.
  void refine(int triangle)
  {
    if (this->Now.isGone(triangle) ||
      this->angle(this->Now.triangle(triangle)) >= Tuning::PoorFeatureAngle)
    {
      return;
    }
    Triangle t = this->Now.triangle(triangle);
    const auto length = [&](int k) { return this->length(Vertex(t[k]), Vertex(t[(k + 1) % 3])); };
    while (length(0) < length(1) || length(0) < length(2))
    {
      std::rotate(t.begin(), t.begin() + 1, t.end());
    }
    const Vertex a(t[0]);
    const Vertex b(t[1]);
    const double spacing = 0.5 * (this->spacingAt(a) + this->spacingAt(b));
    if (length(0) <= 4. / 3. * spacing)
    {
      return;
    }
    if (this->Now.isCrease(a, b))
    {
      const Vec3 along = this->position(b) - this->position(a);
      const double foot =
        (this->position(t[2]) - this->position(a)).dot(along) / along.squaredNorm();
      this->splitCrease(a, b, std::clamp(foot, Tuning::NearestSplit, 1. - Tuning::NearestSplit));
    }
    else if (this->IsFree[a] == 0 && this->IsFree[b] == 0)
    {
      this->splitBetween(a, b);
    }
  }

private:
  /// How far the surface may move for a triangle. One without an angle is worth the whole
  /// tolerance, one that is good enough nothing.
  double worthOf(Vertex v, double angle) const
  {
    return (1. - angle / Tuning::PoorFeatureAngle) * this->Tolerance * this->spacingAt(v);
  }
  /// Of v, and of what has gone to it, from the creases that go with it to u; if there are none,
  /// from the triangles: how far the surface moves. Where it goes farther than the spacing, the
  /// middles of its edges, too.
  double distanceOfCollapse(Vertex v, Vertex u) const
  {
    const Vec3& end = this->position(u);
    const bool isOnCrease = this->Now.numberOfCreases(v) > 0;
    const std::vector<Vertex> ring = this->Now.ring(v);
    const auto distanceOf = [&](const Vec3& p) {
      double least = (p - end).norm();
      for (const Vertex w : ring)
      {
        if (w != u && this->Now.isCrease(v, w))
        {
          least = std::min(least, distanceToSegment(p, end, this->position(w)));
        }
      }
      return isOnCrease ? least : std::min(least, this->distanceToRest(p, v, u));
    };
    double largest = distanceOf(this->position(v));
    const std::vector<Vec3>& absorbed = this->Absorbed[v];
    if (std::any_of(absorbed.begin(), absorbed.end(),
          [&](const Vec3& p) { return distanceOf(p) > this->Tolerance * this->spacingAt(v); }))
    {
      return Never;
    }
    if (this->length(v, u) > this->spacingAt(v))
    {
      for (const Vertex w : ring)
      {
        const Vec3 middle = 0.5 * (this->position(v) + this->position(w));
        largest = std::max(largest, this->distanceToRest(middle, v, u));
      }
    }
    return largest;
  }
  /// Whether an edge comes of v going to u that has no length: where the surface touches itself,
  /// two vertices are at one place.
  bool joinsOnePlace(Vertex v, Vertex u) const
  {
    const std::vector<Vertex> ring = this->Now.ring(v);
    return std::any_of(ring.begin(), ring.end(),
      [&](Vertex w) { return w != u && this->position(w) == this->position(u); });
  }
  /// How far the surface moves if v goes to u, where triangles get better by that; else Never.
  double distanceOfUsefulCollapse(Vertex v, Vertex u)
  {
    const int creases = this->Now.numberOfCreases(v);
    // A vertex inside a line may also go to the line's end.
    const bool isAlongLine = creases == 2 && this->Now.isCrease(v, u);
    const bool mayGo = !this->Mesh.isConstraint(v) &&
      (creases <= this->Now.numberOfCreases(u) || isAlongLine) &&
      (creases > 0 || !this->Mesh.isFree(u) ||
        this->length(v, u) < Tuning::LeastSoundHeight * this->spacingAt(v)); // one on the other
    if (!mayGo || !this->Now.keepsLines(v, u) || !this->Now.mayCollapse(v, u) ||
      !this->staysOpen(v, u) || this->joinsOnePlace(v, u))
    {
      return Never;
    }
    double worstBefore = 10;
    double worstAfter = 10;
    double gain = 0;
    const auto lack = [](double angle) { return std::max(0., Tuning::PoorFeatureAngle - angle); };
    for (const int t : this->Now.about(v))
    {
      const Triangle& before = this->Now.triangle(t);
      const double angleBefore = this->angle(before);
      worstBefore = std::min(worstBefore, angleBefore);
      gain += lack(angleBefore);
      if (!has(before, u))
      {
        const Triangle after = replaced(before, v, u);
        const double angleAfter = this->angle(after);
        worstAfter = std::min(worstAfter, angleAfter);
        gain -= lack(angleAfter);
        if (this->isTurnedOver(before, after))
        {
          return Never;
        }
      }
    }
    const double distance = this->distanceOfCollapse(v, u);
    return gain > Tuning::LeastGainOfCollapse &&
        worstAfter > worstBefore - Tuning::LeastGainOfCollapse &&
        distance <= this->worthOf(v, worstBefore) && this->collapseStaysApart(v, u)
      ? distance
      : Never;
  }
  /// Collapses an edge that third vertices obstruct, after edges from there to its ends have been
  /// swapped; all stays as it was if that is no use.
  bool collapseAfterSwaps(Vertex v, Vertex u, int depth = 0)
  {
    const std::vector<Vertex> obstacles = this->Now.obstacles(v, u);
    if (obstacles.empty())
    {
      return depth > 0 && this->collapseOneOf({ { v, u } });
    }
    if (depth + static_cast<int>(obstacles.size()) > Tuning::MostObstacles)
    {
      return false;
    }
    const Vertex w = obstacles.front();
    for (const Vertex e : { v, u })
    {
      const std::vector<int> pair = this->Now.beside(e, w);
      if (this->Now.isCrease(e, w) || pair.size() != 2)
      {
        continue;
      }
      const std::array<Triangle, 2> before = { { this->Now.triangle(pair[0]),
        this->Now.triangle(pair[1]) } };
      const Vertex p = apexOf(before[0], e, w);
      const Vertex q = apexOf(before[1], e, w);
      if (p == q || !this->Now.beside(p, q).empty() || !this->swapStaysApart(e, w))
      {
        continue;
      }
      this->Now.swap(e, w);
      if (!this->isTurnedOver(before[0], this->Now.triangle(pair[0])) &&
        !this->isTurnedOver(before[1], this->Now.triangle(pair[1])) &&
        this->collapseAfterSwaps(v, u, depth + 1))
      {
        return true;
      }
      this->Now.swap(p, q);
    }
    return false;
  }
  /// Collapses the edge, from the first to the second vertex, that moves the surface least, if it
  /// is useful.
  bool collapseOneOf(const std::vector<std::pair<Vertex, Vertex>>& edges)
  {
    double least = Never;
    std::pair<Vertex, Vertex> best;
    for (const auto& [v, u] : edges)
    {
      const double distance = this->distanceOfUsefulCollapse(v, u);
      if (distance < least)
      {
        least = distance;
        best = { v, u };
      }
    }
    if (least < Never)
    {
      this->collapse(best.first, best.second);
      ++this->NumberOfFeatures;
    }
    return least < Never;
  }
  /// Leads the crease from p to q over v, if triangles are better then.
  bool bend(Vertex p, Vertex q, Vertex v)
  {
    const std::vector<int> pair = this->Now.beside(p, q);
    const double distance =
      distanceToSegment(this->position(v), this->position(p), this->position(q));
    const bool isOnIt = distance < Tuning::NoAngle * this->length(p, q);
    if ((this->Mesh.isFree(v) && !isOnIt) || !this->Now.isCrease(p, q) ||
      this->Now.keep(p, q) != Keep::Nothing || pair.empty() || pair.size() > 2 ||
      !(pair.size() == 2 ? this->mayBend(pair, p, q, v, distance)
                         : isOnIt && !this->Now.isOnBoundary(v)))
    {
      return false;
    }
    this->Now.bend(p, q, v);
    this->Fixed.push_back(v);
    ++this->NumberOfFeatures;
    return true;
  }
  bool mayBend(const std::vector<int>& pair, Vertex p, Vertex q, Vertex v, double distance)
  {
    const bool isFirst = has(this->Now.triangle(pair[0]), v);
    const Triangle& own = this->Now.triangle(pair[isFirst ? 0 : 1]);
    const Triangle& other = this->Now.triangle(pair[isFirst ? 1 : 0]);
    const std::vector<Triangle> after = { replaced(other, q, v), replaced(other, p, v) };
    const Vertex d = apexOf(other, p, q);
    const double worst = std::min(this->angle(own), this->angle(other));
    return d != v && this->Now.beside(v, d).empty() && distance <= this->worthOf(v, worst) &&
      std::min(this->angle(after[0]), this->angle(after[1])) >
      worst + Tuning::LeastGainOfCollapse &&
      !this->isTurnedOver(other, after[0]) && !this->isTurnedOver(other, after[1]) &&
      this->staysApart(pair, after, Pairs::Held);
  }
  /// Swaps the edge from p to q, which v is close to, for one from v, if triangles are better then;
  /// an edge that is there already is swapped for another one first.
  bool swapOver(Vertex p, Vertex q, Vertex v)
  {
    const std::vector<int> pair = this->Now.beside(p, q);
    if (this->Now.isCrease(p, q) || pair.size() != 2)
    {
      return false;
    }
    const Triangle& first = this->Now.triangle(pair[0]);
    const Triangle& other = has(first, v) ? this->Now.triangle(pair[1]) : first;
    const Vertex d = apexOf(other, p, q);
    const double worst = std::min(this->angle(first), this->angle(this->Now.triangle(pair[1])));
    const double farthest = this->worthOf(v, worst);
    if (d == v ||
      distanceToSegment(this->position(v), this->position(p), this->position(q)) > farthest)
    {
      return false;
    }
    const std::vector<int> inTheWay = this->Now.beside(v, d);
    if (inTheWay.empty())
    {
      return this->swapIfBetter(p, q, worst);
    }
    if (this->Now.isCrease(v, d) || inTheWay.size() != 2)
    {
      return false;
    }
    const Vertex a = apexOf(this->Now.triangle(inTheWay[0]), v, d);
    const Vertex b = apexOf(this->Now.triangle(inTheWay[1]), v, d);
    const Vec3 middle = 0.5 * (this->position(a) + this->position(b));
    if (a == b || distanceToSegment(middle, this->position(v), this->position(d)) > farthest ||
      !this->swapIfBetter(v, d, worst))
    {
      return false;
    }
    if (this->swapIfBetter(p, q, worst))
    {
      return true;
    }
    this->Now.swap(a, b);
    return false;
  }
  /// If no triangle turns over, and both have a larger angle than that.
  bool swapIfBetter(Vertex a, Vertex b, double worst)
  {
    const std::vector<int> pair = this->Now.beside(a, b);
    if (pair.size() != 2)
    {
      return false;
    }
    const std::array<Triangle, 2> before = { { this->Now.triangle(pair[0]),
      this->Now.triangle(pair[1]) } };
    const Vertex c = apexOf(before[0], a, b);
    const Vertex d = apexOf(before[1], a, b);
    if (c == d || !this->Now.beside(c, d).empty() || !this->swapStaysApart(a, b))
    {
      return false;
    }
    this->Now.swap(a, b);
    for (int k = 0; k < 2; ++k)
    {
      const Triangle& now = this->Now.triangle(pair[k]);
      if (this->angle(now) <= worst + Tuning::LeastGainOfCollapse ||
        this->isTurnedOver(before[0], now) || this->isTurnedOver(before[1], now))
      {
        this->Now.swap(c, d);
        return false;
      }
    }
    ++this->NumberOfSwaps;
    return true;
  }
  /// Where v is on the edge from p to q and joined to what is beyond it already, a vertex that is
  /// needed less elsewhere goes beyond it, if triangles have angles then.
  bool openWithVertex(Vertex p, Vertex q, Vertex v)
  {
    const std::vector<int> pair = this->Now.beside(p, q);
    if (this->Now.isCrease(p, q) || pair.size() != 2)
    {
      return false;
    }
    const bool isFirst = has(this->Now.triangle(pair[0]), v);
    const Triangle own = this->Now.triangle(pair[isFirst ? 0 : 1]);
    const Triangle other = this->Now.triangle(pair[isFirst ? 1 : 0]);
    const Vertex d = apexOf(other, p, q);
    const Vec3 centre = (this->position(p) + this->position(q) + this->position(d)) / 3.;
    const std::optional<SurfacePoint> place =
      this->placeNear(centre, { { d, p, q, v } }, (centre - this->position(v)).norm());
    if (!place || !this->isBeyond(place->position, p, q, own, other) || !this->hasSpare())
    {
      return false;
    }
    const Vertex m = this->takeSpare(*place, true);
    this->Placed.push_back(m);
    this->Now.split(p, q, m);
    ++this->NumberOfSwaps;
    return true;
  }
  /// Whether a vertex on the edge from p to q, of which one triangle has no area, makes four of
  /// both that have angles and face as the other one does.
  bool isBeyond(
    const Vec3& place, Vertex p, Vertex q, const Triangle& own, const Triangle& other) const
  {
    const Vec3 normal = this->normal(other);
    const auto isFine = [&](const Triangle& t, Vertex gone) {
      std::array<Vec3, 3> x;
      std::transform(t.begin(), t.end(), x.begin(),
        [&](int v) { return Vertex(v) == gone ? place : this->position(v); });
      return angleOf(x) > Tuning::NoAngle && (x[1] - x[0]).cross(x[2] - x[0]).dot(normal) > 0;
    };
    return isFine(own, p) && isFine(own, q) && isFine(other, p) && isFine(other, q);
  }
  /// Puts a vertex from elsewhere on a crease.
  void splitCrease(Vertex a, Vertex b, double share)
  {
    const auto places = this->Now.onChains(a, b, share);
    const std::vector<int> beside = this->Now.beside(a, b);
    if (places.empty() || beside.empty() || beside.size() > 2)
    {
      return;
    }
    // Where creases have become one, it runs along neither: nearest to that which is nearest.
    const Vec3 straight = (1. - share) * this->position(a) + share * this->position(b);
    SurfacePoint there;
    const LooseTriangles::OnChain* nearest = nullptr;
    for (const LooseTriangles::OnChain& place : places)
    {
      const SurfacePoint point =
        this->Mesh.pointAt(this->Mesh.atlas().placeOfBackbone(place.chain, place.arcLength));
      if (!nearest || (point.position - straight).norm() < (there.position - straight).norm())
      {
        there = point;
        nearest = &place;
      }
    }
    std::vector<Triangle> before;
    std::transform(beside.begin(), beside.end(), std::back_inserter(before),
      [&](int t) { return this->Now.triangle(t); });
    if (this->Now.keep(a, b) == Keep::Edges ||
      (there.position - straight).norm() > Tuning::FarthestOffEdge * this->length(a, b) ||
      !this->isNoWorseWith(there.position, a, b, before) || !this->hasSpare())
    {
      return;
    }
    const Vertex m = this->takeSpare(there, false);
    this->Now.splitCrease(a, b, places, m);
    if (places.size() > 1)
    {
      this->Fixed.push_back(m);
    }
    this->OnBackbones.push_back({ m, nearest->chain, nearest->arcLength });
    ++this->NumberOfSwaps;
  }
  /// Puts one in the middle of an edge between creases.
  void splitBetween(Vertex a, Vertex b)
  {
    const std::vector<int> beside = this->Now.beside(a, b);
    if (beside.size() != 2)
    {
      return;
    }
    const std::vector<Triangle> before = { this->Now.triangle(beside[0]),
      this->Now.triangle(beside[1]) };
    const std::optional<SurfacePoint> place =
      this->placeNear(0.5 * (this->position(a) + this->position(b)),
        { { apexOf(before[0], a, b), apexOf(before[1], a, b), a, b } },
        Tuning::FarthestOffEdge * this->length(a, b));
    const auto isBehind = [&](const Triangle& t) { // on another side of a crease
      const Vec3 normal = this->normal(t);
      return place->normal.dot(normal) < Tuning::LeastAgreement * normal.norm();
    };
    if (place && std::none_of(before.begin(), before.end(), isBehind) &&
      this->isNoWorseWith(place->position, a, b, before) && this->hasSpare())
    {
      const Vertex m = this->takeSpare(*place, true);
      this->Placed.push_back(m);
      this->Now.split(a, b, m);
      ++this->NumberOfSwaps;
    }
  }
  /// Whether the triangles at an edge have angles that are as large when a vertex there has split
  /// it, and none turns over.
  bool isNoWorseWith(
    const Vec3& middle, Vertex a, Vertex b, const std::vector<Triangle>& triangles) const
  {
    double worst = 10;
    for (const Triangle& t : triangles)
    {
      worst = std::min(worst, this->angle(t));
    }
    return worst > Tuning::HopelessAngle &&
      std::all_of(triangles.begin(), triangles.end(), [&](const Triangle& t) {
        const Vec3 normal = this->normal(t);
        return std::all_of(t.begin(), t.end(), [&](int gone) {
          if (Vertex(gone) != a && Vertex(gone) != b)
          {
            return true;
          }
          std::array<Vec3, 3> p;
          std::transform(t.begin(), t.end(), p.begin(),
            [&](int v) { return v == gone ? middle : this->position(v); });
          return angleOf(p) > worst - Tuning::LeastGainOfCollapse &&
            (p[1] - p[0]).cross(p[2] - p[0]).dot(normal) > 0;
        });
      });
  }

  static constexpr double Never = 1e300;
};
}

Status simplifyFeatures(OptimizedMesh& mesh, double tolerance, double poorAngle)
{
  if (tolerance <= 0)
  {
    return Status::success();
  }
  std::vector<std::pair<double, int>> poor;
  for (const Face f : mesh.faces())
  {
    const auto corners = mesh.corners(f);
    const bool isFree =
      std::all_of(corners.begin(), corners.end(), [&](Vertex v) { return mesh.isFree(v); });
    const double quality = isFree ? 10. : faceQuality(mesh, f);
    if (quality < poorAngle)
    {
      poor.emplace_back(quality, f.index());
    }
  }
  if (poor.empty())
  {
    return Status::success();
  }
  std::sort(poor.begin(), poor.end());
  Simplification simplification(mesh, tolerance);
  for (const auto& [quality, face] : poor)
  {
    simplification.improve(face);
  }
  for (const auto& [quality, face] : poor)
  {
    simplification.refine(face);
  }
  OptimizedMesh::Change change = simplification.finish();
  return change.features + change.swaps == 0 ? Status::success() : mesh.rebuild(std::move(change));
}
}
