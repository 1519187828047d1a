// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureSimplification.h"

#include "LooseTriangles.h"
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
class Simplification
{
public:
  Simplification(const OptimizedMesh& mesh, double tolerance)
    : Mesh(mesh)
    , Tolerance(tolerance)
    , Spacing(spacingAtUnitDensity(mesh))
    , Largest(Tuning::FarthestOfDiagonal * mesh.atlas().surface().boundingBoxDiagonal())
    , Now(mesh)
  {
    for (const Vertex v : mesh.vertices())
    {
      this->Absorbed.push_back(mesh.absorbed(v));
      this->Place.push_back(mesh.state(v));
      this->IsFree.push_back(mesh.isFree(v));
    }
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

  /// The longest edge of a poor triangle gets a vertex that is needed less elsewhere, as in Delaunay
  /// refinement (Ruppert 1995), where nothing simpler helped: an edge of creases, or between two.
  /// So long an edge that its halves are closer to the spacing, or as close (Botsch and Kobbelt
  /// 2004); so this ends.
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
      const double foot = (this->position(t[2]) - this->position(a)).dot(along) / along.squaredNorm();
      this->splitCrease(a, b, std::clamp(foot, Tuning::NearestSplit, 1. - Tuning::NearestSplit));
    }
    else if (this->IsFree[a] == 0 && this->IsFree[b] == 0)
    {
      this->splitBetween(a, b);
    }
  }

  /// Puts what was freed where triangles are largest; nothing if all is creases.
  OptimizedMesh::Change finish()
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
          std::for_each(beside.begin(), beside.end(), [&](int t) { used[t] = 1; });
          const Vertex v = this->Freed[placed++];
          this->Place[v] = middle;
          this->IsFree[v] = 1;
          this->Now.split(a, b, v);
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
    change.features = this->NumberOfCollapses + this->NumberOfBends;
    change.swaps = this->NumberOfSwaps;
    return change;
  }

private:
  const Vec3& position(int v) const { return this->Place[Vertex(v)].position; }
  const Vec3& position(Vertex v) const { return this->Place[v].position; }
  double length(Vertex a, Vertex b) const { return (this->position(a) - this->position(b)).norm(); }
  Vec3 normal(const Triangle& t) const
  {
    const Vec3& p = this->position(t[0]);
    return (this->position(t[1]) - p).cross(this->position(t[2]) - p);
  }
  /// The smallest.
  static double angleOf(const std::array<Vec3, 3>& p)
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
  double angle(const Triangle& t) const
  {
    return angleOf({ { this->position(t[0]), this->position(t[1]), this->position(t[2]) } });
  }
  double spacingAt(Vertex v) const { return this->Spacing / std::sqrt(this->Mesh.density(v)); }
  /// How far the surface may move.
  double farthestAt(Vertex v) const
  {
    return this->Tolerance * std::min(this->spacingAt(v), this->Largest);
  }
  /// How far it may for a triangle. One without an angle is worth the whole
  /// tolerance, one that is good enough nothing.
  double worthOf(Vertex v, double angle) const
  {
    return (1. - angle / Tuning::PoorFeatureAngle) * this->farthestAt(v);
  }

  /// Whether a triangle turns its back on the surface at its free corners, or on how it was.
  bool isTurnedOver(const Triangle& before, const Triangle& after) const
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

  /// No triangle about v is folded onto a neighbour after v has gone to u, unless it was.
  bool staysOpen(Vertex v, Vertex u) const
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

  /// From a place to the nearest triangle that is left about v when v has gone to u.
  double distanceToRest(const Vec3& p, Vertex v, Vertex u) const
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
          [&](const Vec3& p) { return distanceOf(p) > this->farthestAt(v); }))
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

  /// How far the surface moves if v goes to u, where triangles get better by that; else Never.
  double distanceOfUsefulCollapse(Vertex v, Vertex u) const
  {
    const int creases = this->Now.numberOfCreases(v);
    const bool mayGo = !this->Mesh.isConstraint(v) && creases <= this->Now.numberOfCreases(u) &&
      (creases > 0 || !this->Mesh.isFree(u) ||
        this->length(v, u) < Tuning::LeastSoundHeight * this->spacingAt(v)); // one on the other
    if (!mayGo || !this->Now.keepsLines(v, u) || !this->Now.mayCollapse(v, u) ||
      !this->staysOpen(v, u))
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
        distance <= this->worthOf(v, worstBefore)
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
      if (p == q || !this->Now.beside(p, q).empty())
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
      ++this->NumberOfCollapses;
    }
    return least < Never;
  }
  void collapse(Vertex v, Vertex u)
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
    ++this->NumberOfBends;
    return true;
  }
  bool mayBend(const std::vector<int>& pair, Vertex p, Vertex q, Vertex v, double distance) const
  {
    const bool isFirst = has(this->Now.triangle(pair[0]), v);
    const Triangle& own = this->Now.triangle(pair[isFirst ? 0 : 1]);
    const Triangle& other = this->Now.triangle(pair[isFirst ? 1 : 0]);
    const Triangle after[] = { replaced(other, q, v), replaced(other, p, v) };
    const Vertex d = apexOf(other, p, q);
    const double worst = std::min(this->angle(own), this->angle(other));
    return d != v && this->Now.beside(v, d).empty() && distance <= this->worthOf(v, worst) &&
      std::min(this->angle(after[0]), this->angle(after[1])) >
      worst + Tuning::LeastGainOfCollapse &&
      !this->isTurnedOver(other, after[0]) && !this->isTurnedOver(other, after[1]);
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
    if (c == d || !this->Now.beside(c, d).empty())
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

  /// Where v is on the edge from p to q and joined to what is beyond it already, a vertex goes
  /// there that is needed less elsewhere; no place of the surface moves.
  bool openWithVertex(Vertex p, Vertex q, Vertex v)
  {
    const std::vector<int> pair = this->Now.beside(p, q);
    if (this->Now.isCrease(p, q) || pair.size() != 2)
    {
      return false;
    }
    const Triangle other = this->Now.triangle(pair[has(this->Now.triangle(pair[0]), v) ? 1 : 0]);
    const Vertex d = apexOf(other, p, q);
    const Vec3 centre = (this->position(p) + this->position(q) + this->position(d)) / 3.;
    const std::optional<SurfacePoint> place = this->placeNear(
      centre, { { d, p, q, v } }, Tuning::FarthestOffEdge * (centre - this->position(v)).norm());
    if (!place || !this->hasSpare())
    {
      return false;
    }
    const Vertex m = this->takeSpare(*place, true);
    this->Placed.push_back(m);
    this->Now.split(p, q, m);
    ++this->NumberOfSwaps;
    return true;
  }
  /// The nearest place to one in space, less far from it than that, at which straight walks from
  /// vertices end.
  std::optional<SurfacePoint> placeNear(
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
  bool hasSpare() { return !this->Freed.empty() || this->freeOne(); }
  /// A vertex from elsewhere, for another place.
  Vertex takeSpare(const SurfacePoint& place, bool isFree)
  {
    const Vertex v = this->Freed.back();
    this->Freed.pop_back();
    this->Place[v] = place;
    this->IsFree[v] = isFree ? 1 : 0;
    return v;
  }

  /// How good triangles about an inner vertex and its neighbours, all free, are if it goes to one of
  /// these: their smallest angle.
  double angleWithout(Vertex v, Vertex u) const
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
    return worst;
  }
  bool isInside(Vertex v) const
  {
    const std::vector<Vertex> ring = this->Now.ring(v);
    return !ring.empty() && this->Mesh.isFree(v) && this->IsFree[v] != 0 &&
      std::all_of(ring.begin(), ring.end(), [&](Vertex u) { return this->IsFree[u] != 0; }) &&
      !this->Now.isOnBoundary(v);
  }
  /// Collapses that cost least, of vertices inside faces, some of which are looked at; the best
  /// last.
  std::vector<std::pair<double, VertexPair>> spareVertices() const
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
  /// Frees a vertex inside faces, where triangles stay best.
  bool freeOne()
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
        return true;
      }
    }
    return false;
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
      !this->isNoWorseWith(there.position, a, b, before) ||
      !this->hasSpare())
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
    return worst > Tuning::HopelessAngle && std::all_of(triangles.begin(), triangles.end(), [&](const Triangle& t) {
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
          (this->angle(t) < Tuning::LeastSoundHeight ||
            (p[1] - p[0]).cross(p[2] - p[0]).dot(normal) > 0);
      });
    });
  }

  /// Under the wanted density, up to a factor.
  double areaOf(const Triangle& t) const
  {
    double density = 0;
    for (const int v : t)
    {
      density += this->Mesh.density(Vertex(v));
    }
    return density * this->normal(t).norm();
  }
  /// The edges between two triangles, no creases, with a free end, of so many largest triangles:
  /// first those with the largest two.
  std::vector<VertexPair> widestEdges(std::size_t numberOfTriangles) const
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
  /// Of an edge with a free end, on the surface.
  SurfacePoint middle(Vertex a, Vertex b) const
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
  /// Not where one of them is: a walk from a crease may begin on the wrong side of it, and end
  /// there.
  bool isBetween(const Vec3& place, Vertex a, Vertex b) const
  {
    return std::min((place - this->position(a)).norm(), (place - this->position(b)).norm()) >=
      Tuning::FarthestOffEdge * this->length(a, b);
  }

  static constexpr double Never = 1e300;
  const OptimizedMesh& Mesh;
  const double Tolerance; // over the spacing
  const double Spacing;   // at a density of 1
  const double Largest;   // of what a whole tolerance allows
  LooseTriangles Now;
  ElementArray<Vertex, SurfacePoint> Place;
  ElementArray<Vertex, char> IsFree;
  ElementArray<Vertex, std::vector<Vec3>> Absorbed; // places of what has gone there
  std::vector<Vertex> Freed;
  std::vector<Vertex> Placed; // of those that were
  std::vector<Vertex> Fixed;
  std::vector<OptimizedMesh::Change::OnBackbone> OnBackbones;
  std::vector<std::pair<double, VertexPair>> Spare; // collapses that cost little, the best last
  bool HasLookedForSpare = false;
  int NumberOfCollapses = 0;
  int NumberOfBends = 0;
  int NumberOfSwaps = 0; // and vertices that open triangles or split creases
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
