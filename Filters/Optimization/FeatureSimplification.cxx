// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureSimplification.h"

#include "Relaxation.h"
#include "SurfaceError.h"
#include "Tuning.h"
#include "VertexStar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace stipple
{
namespace
{
using Chain = OptimizedMesh::Chain;
using VertexPair = std::pair<Vertex, Vertex>;

VertexPair pairOf(Vertex a, Vertex b)
{
  return { std::min(a, b), std::max(a, b) };
}

bool has(const Triangle& t, Vertex v)
{
  return std::find(t.begin(), t.end(), v.index()) != t.end();
}

/// The third corner of a triangle.
Vertex apexOf(const Triangle& t, Vertex a, Vertex b)
{
  return Vertex(t[0] + t[1] + t[2] - a.index() - b.index());
}

Triangle replaced(Triangle t, Vertex v, Vertex by)
{
  std::replace(t.begin(), t.end(), v.index(), by.index());
  return t;
}

/// The mesh's triangles and chains, to be changed in ways that MeshEdit has not.
class LooseTriangles
{
public:
  explicit LooseTriangles(const OptimizedMesh& mesh)
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

  /// Those that were there at first come first; those that are gone have no corners.
  const std::vector<Triangle>& triangles() const { return this->Triangles; }
  const Triangle& triangle(int t) const { return this->Triangles[t]; }
  bool isGone(int t) const { return this->Triangles[t][0] < 0; }
  const std::vector<Chain>& chains() const { return this->Chains; }
  const std::vector<int>& about(Vertex v) const { return this->About[v]; }
  const std::vector<int>& chainsOf(Vertex v) const { return this->ChainsOf[v]; }
  bool isCrease(Vertex a, Vertex b) const { return this->Creases.count(pairOf(a, b)) > 0; }
  /// What is to be kept of an edge.
  Keep keep(Vertex a, Vertex b) const
  {
    const auto found = this->Creases.find(pairOf(a, b));
    return found == this->Creases.end() ? Keep::Nothing : found->second;
  }

  /// The vertices that edges join to one, ascending.
  std::vector<Vertex> ring(Vertex v) const
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
  /// The triangles of an edge.
  std::vector<int> beside(Vertex a, Vertex b) const
  {
    std::vector<int> result;
    std::copy_if(this->About[a].begin(), this->About[a].end(), std::back_inserter(result),
      [&](int t) { return has(this->Triangles[t], b); });
    return result;
  }
  /// The triangles over a triangle's edges.
  std::vector<int> neighbours(int t) const
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
  int numberOfCreases(Vertex v) const
  {
    const std::vector<Vertex> ring = this->ring(v);
    return static_cast<int>(
      std::count_if(ring.begin(), ring.end(), [&](Vertex u) { return this->isCrease(u, v); }));
  }
  /// Whether lines that must stay do, and regions stay apart, when v has gone to u: v may lie
  /// inside a border that leads to u, with nothing of it on the triangles that go.
  bool keepsLines(Vertex v, Vertex u) const
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
          return !this->isCrease(v, w) && !this->isCrease(u, w);
        }));
  }
  bool isOnBoundary(Vertex v) const
  {
    const std::vector<Vertex> ring = this->ring(v);
    return std::any_of(
      ring.begin(), ring.end(), [&](Vertex u) { return this->beside(u, v).size() == 1; });
  }

  /// Whether a manifold of the same topology is left when v has gone to u: the link condition (Dey,
  /// Edelsbrunner, Guha and Nekhayev 1999).
  bool mayCollapse(Vertex v, Vertex u) const
  {
    const std::vector<int> gone = this->beside(v, u);
    const std::vector<Vertex> a = this->ring(v);
    const std::vector<Vertex> b = this->ring(u);
    std::vector<Vertex> common;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
    return common.size() == gone.size() &&
      std::all_of(
        common.begin(), common.end(), [&](Vertex w) { return this->ring(w).size() > 3; }) &&
      (gone.size() == 1 || !this->isOnBoundary(v) || !this->isOnBoundary(u));
  }
  /// Moves v to u. Creases go with it.
  void collapse(Vertex v, Vertex u)
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

  /// Swaps the crease (p, q) between two triangles for the edge between their other corners, v and
  /// another one, and leads its chains over v. On a boundary, the triangle goes.
  void bend(Vertex p, Vertex q, Vertex v)
  {
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
    this->Creases.erase(pairOf(p, q));
    this->Creases.try_emplace(pairOf(p, v), Keep::Nothing);
    this->Creases.try_emplace(pairOf(v, q), Keep::Nothing);
    std::vector<int> chains = this->ChainsOf[p];
    makeUnique(chains);
    for (const int b : chains)
    {
      Chain& chain = this->Chains[b];
      for (std::size_t i = 1; i < chain.size(); ++i)
      {
        if (pairOf(chain[i - 1].vertex, chain[i].vertex) == pairOf(p, q))
        {
          const double length = this->Mesh.atlas().traces()[b].length();
          const bool isClosed = this->Mesh.atlas().graph().backbones[b].closed;
          const double begin = chain[i - 1].arcLength;
          const double end =
            chain[i].arcLength + (isClosed && chain[i].arcLength <= begin ? length : 0.);
          const double middle = std::fmod(0.5 * (begin + end), length);
          chain.insert(chain.begin() + static_cast<std::ptrdiff_t>(i), { v, middle });
          this->ChainsOf[v].push_back(b);
        }
      }
    }
  }

  /// Vertices that edges join to both ends of an edge without a triangle between the three: while
  /// there are any, it may not be collapsed.
  std::vector<Vertex> obstacles(Vertex v, Vertex u) const
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

  /// Swaps an edge between two triangles, no crease, for the one between their other corners.
  void swap(Vertex p, Vertex q)
  {
    const std::vector<int> pair = this->beside(p, q);
    const Triangle first = this->Triangles[pair[0]];
    const Triangle second = this->Triangles[pair[1]];
    this->put(pair[0], replaced(first, q, apexOf(second, p, q)));
    this->put(pair[1], replaced(second, p, apexOf(first, p, q)));
  }

  /// Puts a vertex, which is in no triangle, on an edge between two.
  void split(Vertex a, Vertex b, Vertex middle)
  {
    for (const int t : this->beside(a, b))
    {
      const Triangle whole = this->Triangles[t];
      this->put(t, replaced(whole, b, middle));
      this->Triangles.push_back({ -1, -1, -1 });
      this->put(static_cast<int>(this->Triangles.size()) - 1, replaced(whole, a, middle));
    }
  }

private:
  void put(int t, const Triangle& corners)
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
    for (const int v : corners)
    {
      if (v >= 0)
      {
        this->About[Vertex(v)].push_back(t);
      }
    }
  }
  static void replaceIn(Chain& chain, Vertex v, Vertex u)
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

  const OptimizedMesh& Mesh;
  std::vector<Triangle> Triangles;
  std::vector<Chain> Chains;
  ElementArray<Vertex, std::vector<int>> About;    // of its triangles
  ElementArray<Vertex, std::vector<int>> ChainsOf; // of a vertex; some of them more than once
  std::map<VertexPair, Keep> Creases;
};

class Simplification
{
public:
  Simplification(const OptimizedMesh& mesh, double tolerance)
    : Mesh(mesh)
    , Tolerance(tolerance)
    , Spacing(spacingAtUnitDensity(mesh))
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
    change.chains = this->Now.chains();
    change.absorbed = std::move(this->Absorbed);
    change.features = static_cast<int>(this->Freed.size()) + this->NumberOfBends;
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
  double angle(const Triangle& t) const
  {
    const double area = this->normal(t).norm();
    double least = 10;
    for (int k = 0; k < 3; ++k)
    {
      const Vec3& p = this->position(t[k]);
      const Vec3 u = this->position(t[(k + 1) % 3]) - p;
      const Vec3 w = this->position(t[(k + 2) % 3]) - p;
      least = std::min(least, std::atan2(area, u.dot(w)));
    }
    return least;
  }
  double spacingAt(Vertex v) const { return this->Spacing / std::sqrt(this->Mesh.density(v)); }
  /// How far the surface may move for a triangle. One without an angle is worth the whole
  /// tolerance, one that is good enough nothing.
  double worthOf(Vertex v, double angle) const
  {
    return (1. - angle / Tuning::PoorFeatureAngle) * this->Tolerance * this->spacingAt(v);
  }

  /// Whether a triangle turns its back on the surface at its free corners, or on how it was.
  bool isTurnedOver(const Triangle& before, const Triangle& after) const
  {
    const Vec3 n = this->normal(after);
    Vec3 surface = Vec3::Zero();
    for (const int v : after)
    {
      surface += this->Mesh.isFree(Vertex(v)) ? this->Mesh.normal(Vertex(v)) : Vec3::Zero();
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
    SurfacePoint place;
    double least = Tuning::FarthestOffEdge * (centre - this->position(v)).norm();
    bool isFound = false;
    for (const Vertex from : { d, p, q, v })
    {
      const SurfacePoint end =
        this->Mesh.walk(this->Place[from].place, centre - this->position(from));
      const double distance = (end.position - centre).norm();
      if (distance < least)
      {
        place = end;
        least = distance;
        isFound = true;
      }
    }
    if (!isFound || (this->Freed.empty() && !this->freeOne()))
    {
      return false;
    }
    const Vertex m = this->Freed.back();
    this->Freed.pop_back();
    this->Placed.push_back(m);
    this->Place[m] = place;
    this->IsFree[m] = 1;
    this->Now.split(p, q, m);
    ++this->NumberOfSwaps;
    return true;
  }
  /// Collapses an edge inside faces, of some that are looked at, after which the triangles there
  /// are best.
  bool freeOne()
  {
    constexpr int Looks = 1000;
    const int n = this->Mesh.vertices().size();
    const int step = std::max(1, n / Looks);
    double best = Tuning::SliverAngle;
    VertexPair found;
    for (int i = 0; i < n; i += step)
    {
      const Vertex v(i);
      const std::vector<Vertex> ring = this->Now.ring(v);
      const bool isInside = !ring.empty() && this->Mesh.isFree(v) && this->IsFree[v] != 0 &&
        std::all_of(ring.begin(), ring.end(), [&](Vertex u) { return this->IsFree[u] != 0; }) &&
        !this->Now.isOnBoundary(v);
      for (const Vertex u : isInside ? ring : std::vector<Vertex>())
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
        if (worst > best && this->Now.mayCollapse(v, u) && this->staysOpen(v, u))
        {
          best = worst;
          found = { v, u };
        }
      }
    }
    if (!found.first.valid())
    {
      return false;
    }
    this->collapse(found.first, found.second);
    return true;
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
  LooseTriangles Now;
  ElementArray<Vertex, SurfacePoint> Place;
  ElementArray<Vertex, char> IsFree;
  ElementArray<Vertex, std::vector<Vec3>> Absorbed; // places of what has gone there
  std::vector<Vertex> Freed;
  std::vector<Vertex> Placed; // of those that were
  std::vector<Vertex> Fixed;
  int NumberOfBends = 0;
  int NumberOfSwaps = 0; // and vertices that open triangles
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
  OptimizedMesh::Change change = simplification.finish();
  return change.features + change.swaps == 0 ? Status::success() : mesh.rebuild(std::move(change));
}
}
