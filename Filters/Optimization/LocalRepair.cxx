// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalRepair.h"

#include "EdgeSwaps.h"
#include "MeshRegion.h"
#include "ParallelFor.h"
#include "Relaxation.h"
#include "Tuning.h"
#include "VertexStar.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace stipple
{
namespace
{
bool tryToImprove(MeshEdit& edit, Vertex v, bool staysInRing)
{
  const OptimizedMesh& mesh = edit.mesh();
  const VertexStar star(mesh, v);
  double best = star.quality(mesh.state(v));
  const double start = best;
  double farthest = 0; // that it may be from a neighbour
  std::vector<Vertex> ring;
  const auto isFar = [&](const SurfacePoint& there) {
    return std::any_of(ring.begin(), ring.end(), [&](Vertex u) {
      return (mesh.position(u) - there.position).squaredNorm() > farthest * farthest;
    });
  };
  const auto isBetter = [&](const SurfacePoint& there) {
    if (!star.exceeds(there, best + Tuning::LeastGainOfAngle))
    {
      return false;
    }
    const double quality = star.quality(there);
    if (staysInRing && quality < 0 && isFar(there))
    {
      return false;
    }
    best = quality;
    return true;
  };
  double reach = 0;
  int count = 0;
  Vec3 centre = Vec3::Zero(); // each neighbour weighs as much as it has triangles here
  mesh.forEachFace(v, [&](Face f) {
    for (const Vertex u : mesh.corners(f))
    {
      if (u != v)
      {
        if (std::find(ring.begin(), ring.end(), u) == ring.end())
        {
          ring.push_back(u);
        }
        centre += mesh.position(u);
        reach += (mesh.position(u) - mesh.position(v)).norm();
        ++count;
      }
    }
  });
  centre /= count;
  reach /= count;
  // A place inside the ring is no farther from a neighbour than these are from each other. Folds
  // seem to get better beyond it, too: around a tube, by the way that its surface turns.
  for (auto u = ring.begin(); u != ring.end() && staysInRing && start < 0; ++u)
  {
    farthest = std::max(farthest, (mesh.position(*u) - mesh.position(v)).norm());
    for (auto w = ring.begin(); w != u; ++w)
    {
      farthest = std::max(farthest, (mesh.position(*u) - mesh.position(*w)).norm());
    }
  }
  const auto attempt = [&](const Vec3& step) {
    const SurfacePoint there = mesh.walk(mesh.place(v), step);
    const bool moves = isBetter(there);
    if (moves)
    {
      edit.put(v, there);
    }
    return moves;
  };
  const auto attemptNear = [&](const Vec3& step) {
    // Walks take most of the time: where the tangent plane promises far less, there is none.
    if (best > Tuning::PromisedAngle)
    {
      SurfacePoint promised = mesh.state(v);
      promised.position += step;
      if (!star.exceeds(promised, best - Tuning::PromisedAngle))
      {
        return;
      }
    }
    attempt(step);
  };
  const auto isBetterHere = [&]() { return isBetter(mesh.state(v)); };
  if (mesh.freedom(v) == Freedom::Backbone)
  {
    for (const double size : Tuning::SlideSizes)
    {
      edit.tryAround(v, size * reach, attemptNear, isBetterHere);
    }
    return best > start;
  }
  // Where relaxation would go and to the middle of the ring; then a pattern search about the place.
  Vec3 lloyd;
  bool moved = true;
  for (const double share : { 1., 0.5 })
  {
    moved = attempt(share * (centre - mesh.position(v))) || moved;
    lloyd = moved ? lloydStep(mesh, v) : lloyd;
    moved = attempt(share * lloyd);
  }
  // A vertex that has slipped far out of its ring comes back by the way from its neighbours.
  for (const Vertex u : ring)
  {
    if (best < Tuning::SlippedAngle && mesh.isFree(u))
    {
      const SurfacePoint there = mesh.walk(mesh.place(u), centre - mesh.position(u));
      if ((there.position - centre).norm() < reach && isBetter(there))
      {
        edit.put(v, there);
      }
    }
  }
  for (const double size : Tuning::PatternSizes)
  {
    edit.tryAround(v, size * reach, attemptNear, isBetterHere);
  }
  return best > start;
}

}

bool improveByMove(MeshEdit& edit, Vertex v, bool staysInRing)
{
  const OptimizedMesh& mesh = edit.mesh();
  if (mesh.freedom(v) == Freedom::None || !edit.mayMove(v))
  {
    return false;
  }
  const std::uint64_t now = fingerprintOf(mesh, v);
  if (edit.failedMoves().contains(v, staysInRing, now))
  {
    return false;
  }
  const bool isBetter = tryToImprove(edit, v, staysInRing);
  if (!isBetter)
  {
    edit.failedMoves().add(mesh, v, staysInRing, now);
  }
  return isBetter;
}

bool settle(MeshEdit& edit, const std::vector<Vertex>& vertices, const std::vector<Face>& faces,
  double enough, double wanted, int maximumNumberOfRounds, int* numberOfMoves)
{
  int tried = 0;
  int& moves = numberOfMoves ? *numberOfMoves : tried;
  bool changed = true;
  for (int round = 0; round < maximumNumberOfRounds && changed; ++round)
  {
    changed = false;
    for (const Vertex v : vertices)
    {
      if (starQuality(edit.mesh(), v) < enough)
      {
        ++moves;
        changed = improveByMove(edit, v) || changed;
      }
    }
    if (worstQuality(edit.mesh(), faces) >= wanted)
    {
      return true;
    }
  }
  return false;
}

namespace
{
/// How badly a triangle is folded, below zero.
double foldOf(const OptimizedMesh& mesh, Face f)
{
  return std::min(0., faceQuality(mesh, f));
}

double sumOfFoldAngles(const OptimizedMesh& mesh, const std::vector<Face>& faces)
{
  return std::accumulate(
    faces.begin(), faces.end(), 0., [&](double sum, Face f) { return sum + foldOf(mesh, f); });
}

/// Improves triangles, and remembers what need not be looked at again.
class TriangleRepair
{
public:
  TriangleRepair(MeshEdit& edit, double threshold, bool maySwap, bool mayMove)
    : Edit(edit)
    , Mesh(edit.mesh())
    , Threshold(threshold)
    , MaySwap(maySwap)
    , MayMove(mayMove)
    , Known(static_cast<std::size_t>(edit.mesh().faces().size()), Knowledge::None)
    , IsStuck(static_cast<std::size_t>(edit.mesh().vertices().size()), 0)
  {
  }

  /// Over all triangles; returns whether anything changed.
  bool pass()
  {
    parallelFor(this->Mesh.faces(), [&](Face f) {
      if (this->Known[f] == Knowledge::None && !this->isBad(f))
      {
        this->Known[f] = Knowledge::Good;
      }
    });
    this->Bad = 0;
    bool changed = false;
    for (const Face f : this->Mesh.faces())
    {
      if (this->Known[f] != Knowledge::Good &&
        (this->Known[f] == Knowledge::Stuck || this->isBad(f)))
      {
        ++this->Bad;
        changed = (this->Known[f] != Knowledge::Stuck && this->improve(f)) || changed;
      }
    }
    return changed;
  }
  /// That the last pass met.
  int numberOfBad() const { return this->Bad; }

private:
  enum class Knowledge : char
  {
    None,
    Good,
    Stuck ///< nothing that its repair looks at has changed since it failed
  };

  bool isBad(Face f) const { return faceQuality(this->Mesh, f) < this->Threshold; }
  bool isFolded(Face f) const { return faceQuality(this->Mesh, f) < 0; }

  bool improve(Face f)
  {
    bool helped = this->MaySwap && (this->improveBySwap(f) || this->unfoldByFan(f));
    if (helped && !this->isBad(f))
    {
      return true;
    }
    const auto corners = this->Mesh.corners(f);
    for (int k = 0; this->MayMove && k < 3 && this->isBad(f); ++k)
    {
      helped = this->improveVertex(corners[k]) || helped;
    }
    const bool isFold = this->isFolded(f);
    // The neighbours of a fold may stand in the way.
    for (int k = 0; this->MayMove && k < 3 && this->isFolded(f); ++k)
    {
      for (const Vertex u : cornersOf(this->Mesh, facesAbout(this->Mesh, { corners[k] })))
      {
        helped = this->improveVertex(u) || helped;
      }
    }
    helped = (!helped && isFold && this->unfoldBySwapAndMoves(f)) || helped;
    if (!helped && !isFold)
    {
      this->Known[f] = Knowledge::Stuck;
    }
    return helped;
  }
  bool improveBySwap(Face f)
  {
    Halfedge h = this->Mesh.halfedge(f);
    for (int k = 0; k < 3; ++k, h = this->Mesh.next(h))
    {
      const Edge e = this->Mesh.edge(h);
      if (!this->Mesh.isSwappable(e))
      {
        continue;
      }
      const auto [a, b, c, d] = this->Mesh.wing(e);
      const auto worst = [this](const TriangleCorners& s, const TriangleCorners& t) {
        return std::min(triangleQuality(this->Mesh, s), triangleQuality(this->Mesh, t));
      };
      const double before = worst({ { a, b, c } }, { { b, a, d } });
      const double after = worst({ { d, c, a } }, { { c, d, b } });
      if ((after > before + Tuning::RoundingOfAngle || this->unfoldsBySwap(f, e)) &&
        !this->makesFlat(e) && this->Edit.swap(e))
      {
        for (const Vertex v : this->Mesh.corners(f))
        {
          this->touch(v);
        }
        return true;
      }
    }
    return false;
  }
  /// What is folded covers the surface more than once: the way back leads over less and less area,
  /// if not over triangles that are better one by one. A slot in a flat face may be covered so,
  /// with all corners on creases, where no move helps.
  bool unfoldsBySwap(Face f, Edge e) const
  {
    if (!this->isFolded(f))
    {
      return false;
    }
    const auto [a, b, c, d] = this->Mesh.wingVertices(e);
    const auto area = [this](Vertex p, Vertex q, Vertex r) {
      return triangleArea(this->Mesh.position(p), this->Mesh.position(q), this->Mesh.position(r));
    };
    return area(d, c, a) + area(c, d, b) <
      (1. - Tuning::LeastGainOfArea) * (area(a, b, c) + area(b, a, d));
  }
  /// Whether a triangle without area comes of a swap. One that is folded by its normals may be
  /// right after all, that never is; but where swaps alone take triangles away that lie over a
  /// slot, the way leads over some.
  bool makesFlat(Edge e) const
  {
    const auto [a, b, c, d] = this->Mesh.wing(e);
    return this->MayMove &&
      this->Mesh.isFlat({ { d, c, a } }) + this->Mesh.isFlat({ { c, d, b } }) >
      this->Mesh.isFlat({ { a, b, c } }) + this->Mesh.isFlat({ { b, a, d } });
  }
  /// Joins a corner to more and more vertices beyond its opposite edge: about the tip of a slot,
  /// the triangles that close the gap on one side of it are to be found on the other. Only for
  /// swaps alone: once vertices have moved, folds are theirs, and undone by placing them anew.
  bool unfoldByFan(Face f)
  {
    if (this->MayMove || !this->isFolded(f))
    {
      return false;
    }
    for (const Vertex v : this->Mesh.corners(f))
    {
      std::map<Face, double> before;
      std::vector<Vertex> changed = { v };
      std::vector<Vertex> joined;
      const auto fan = [&]() {
        for (int swaps = 0; swaps < Tuning::SwapsOfFan; ++swaps)
        {
          const Halfedge h = this->worstFoldedAt(v);
          const Edge e = h.valid() ? this->Mesh.edge(this->Mesh.next(h)) : Edge();
          if (!e.valid() || !this->Mesh.isSwappable(e) || !this->Mesh.keepsManifold(e) ||
            !this->Edit.maySwap(e))
          {
            return false;
          }
          for (int side = 0; side < 2; ++side)
          {
            const Face g = this->Mesh.face(this->Mesh.halfedge(e, side));
            before.emplace(g, foldOf(this->Mesh, g));
          }
          const auto quad = this->Mesh.wingVertices(e);
          changed.insert(changed.end(), quad.begin(), quad.end());
          joined.push_back(quad[2] == v ? quad[3] : quad[2]);
          this->Edit.flip(e);
          double gain = 0;
          for (const auto& [g, quality] : before)
          {
            gain += foldOf(this->Mesh, g) - quality;
          }
          if (gain > Tuning::LeastGainOfFolds)
          {
            return std::all_of(
              joined.begin(), joined.end(), [&](Vertex u) { return this->liesOnSurface(u, v); });
          }
        }
        return false;
      };
      if (this->Edit.attempt(fan))
      {
        std::for_each(changed.begin(), changed.end(), [this](Vertex u) { this->touch(u); });
        return true;
      }
    }
    return false;
  }
  /// Whether an edge would run along the surface: a walk of its length and direction then ends near
  /// its end. (From creases, walks may begin on the wrong side.)
  bool liesOnSurface(Vertex from, Vertex to) const
  {
    const Vec3 step = this->Mesh.position(to) - this->Mesh.position(from);
    return !this->Mesh.isFree(from) ||
      (this->Mesh.walk(this->Mesh.place(from), step).position - this->Mesh.position(to)).norm() <=
      Tuning::FarthestOffEdge * step.norm();
  }
  /// Of the folded triangles about a vertex the worst, by its halfedge out of the vertex.
  Halfedge worstFoldedAt(Vertex v) const
  {
    Halfedge worst;
    double least = 0;
    this->Mesh.forEachCorner(v, [&](Halfedge h) {
      const double quality = faceQuality(this->Mesh, this->Mesh.face(h));
      if (quality < least)
      {
        least = quality;
        worst = h;
      }
    });
    return worst;
  }
  /// Where a vertex stands on the line that a swap would join it to, it must move as well.
  bool unfoldBySwapAndMoves(Face f)
  {
    if (!this->MaySwap || !this->MayMove)
    {
      return false;
    }
    Halfedge h = this->Mesh.halfedge(f);
    for (int k = 0; k < 3; ++k, h = this->Mesh.next(h))
    {
      const Edge e = this->Mesh.edge(h);
      if (!this->Mesh.isSwappable(e) || !this->Mesh.keepsManifold(e) || !this->Edit.maySwap(e))
      {
        continue;
      }
      const auto quad = this->Mesh.wingVertices(e);
      const std::vector<Vertex> vertices(quad.begin(), quad.end());
      const std::vector<Face> faces = facesAbout(this->Mesh, vertices);
      const double before = sumOfFoldAngles(this->Mesh, faces);
      const auto flat = [&]() {
        return std::count_if(faces.begin(), faces.end(),
          [&](Face g) { return this->Mesh.isFlat(this->Mesh.triangleCorners(g)); });
      };
      const auto flatBefore = flat();
      const bool isBetter = this->Edit.attempt([&]() {
        this->Edit.flip(e);
        for (const Vertex v : vertices)
        {
          improveByMove(this->Edit, v);
        }
        return sumOfFoldAngles(this->Mesh, faces) > before + Tuning::LeastGainOfFolds &&
          flat() <= flatBefore;
      });
      if (isBetter)
      {
        std::for_each(quad.begin(), quad.end(), [this](Vertex v) { this->touch(v); });
        return true;
      }
    }
    return false;
  }
  bool improveVertex(Vertex v)
  {
    if (this->IsStuck[v])
    {
      return false;
    }
    const bool moved = improveByMove(this->Edit, v, true);
    this->IsStuck[v] = !moved;
    if (moved)
    {
      this->touch(v);
    }
    return moved;
  }
  /// It has moved, or is in other triangles.
  void touch(Vertex v)
  {
    this->Mesh.forEachFace(v, [&](Face f) {
      this->Known[f] = Knowledge::None;
      for (const Vertex u : this->Mesh.corners(f))
      {
        this->IsStuck[u] = 0;
        this->Mesh.forEachFace(u, [&](Face g) {
          this->Known[g] = this->Known[g] == Knowledge::Stuck ? Knowledge::None : this->Known[g];
        });
      }
    });
  }

  MeshEdit& Edit;
  const OptimizedMesh& Mesh;
  const double Threshold;
  const bool MaySwap;
  const bool MayMove;
  ElementArray<Face, Knowledge> Known;
  ElementArray<Vertex, char> IsStuck; // nothing about it has changed since no move helped
  int Bad = 0;
};
}

int repairTriangles(
  MeshEdit& edit, double threshold, bool maySwap, bool mayMove, int maximumNumberOfPasses)
{
  TriangleRepair repair(edit, threshold, maySwap, mayMove);
  for (int pass = 0; pass < maximumNumberOfPasses && repair.pass(); ++pass)
  {
  }
  return repair.numberOfBad();
}

namespace
{
/// Swaps an edge and moves the vertices about it until all triangles there are good; false, and
/// nothing is changed, if that does not succeed.
bool swapAndSettle(MeshEdit& edit, Edge e, double threshold)
{
  const OptimizedMesh& mesh = edit.mesh();
  const auto quad = mesh.wingVertices(e);
  std::vector<Vertex> changing(quad.begin(), quad.end());
  const std::vector<Vertex> movable =
    filtered(withRings(mesh, changing, 1), [&](Vertex v) { return mesh.isFree(v); });
  changing.insert(changing.end(), movable.begin(), movable.end());
  const std::vector<Face> faces = facesAbout(mesh, changing);
  const double wanted = std::min(threshold, worstQuality(mesh, faces));
  return wanted >= Tuning::HopelessAngle && edit.attempt([&]() {
    edit.flip(e);
    return settle(edit, movable, faces, threshold, wanted, Tuning::SettlingRounds);
  });
}
}

int repairValences(MeshEdit& edit, double threshold, int maximumNumberOfPasses)
{
  const OptimizedMesh& mesh = edit.mesh();
  const auto excess = [&](Halfedge h) { return valenceExcess(mesh, h); };
  const auto cost = [](Vertex, int x) { return irregularity(x); };
  // A swap can only gain where one of the four valences is bad.
  ElementArray<Vertex, char> isRegular(static_cast<std::size_t>(mesh.vertices().size()));
  const auto look = [&](Vertex v) {
    isRegular[v] = mesh.isFree(v) && !mesh.isBoundary(v) && irregularity(mesh.valence(v) - 6) == 0;
  };
  parallelFor(mesh.vertices(), look);
  int total = 0;
  for (int pass = 0, swaps = 1; pass < maximumNumberOfPasses && swaps > 0; ++pass)
  {
    swaps = 0;
    for (const Edge e : mesh.edges())
    {
      if (!mesh.isSwappable(e) || !edit.maySwap(e))
      {
        continue;
      }
      const auto quad = mesh.wingVertices(e);
      if (std::all_of(quad.begin(), quad.end(), [&](Vertex v) { return isRegular[v] != 0; }))
      {
        continue;
      }
      if (costChangeOfSwap(mesh, e, excess, cost) < 0 && mesh.keepsManifold(e) &&
        swapAndSettle(edit, e, threshold))
      {
        ++swaps;
        std::for_each(quad.begin(), quad.end(), look);
      }
    }
    total += swaps;
  }
  return total;
}

namespace
{
/// Squared sides of a triangle, under the wanted density.
double squaresOf(const OptimizedMesh& mesh, Face f)
{
  const auto [a, b, c] = mesh.corners(f);
  const Vec3& p = mesh.position(a);
  const Vec3& q = mesh.position(b);
  const Vec3& r = mesh.position(c);
  return (mesh.density(a) + mesh.density(b) + mesh.density(c)) / 3. *
    ((q - p).squaredNorm() + (r - q).squaredNorm() + (p - r).squaredNorm());
}

/// Sum over the triangles about v of the squares of that: least where they are alike and regular.
double unevenness(const OptimizedMesh& mesh, Vertex v)
{
  double sum = 0;
  mesh.forEachFace(v, [&](Face f) {
    const double s = squaresOf(mesh, f);
    sum += s * s;
  });
  return sum;
}
}

void equalizeTriangles(MeshEdit& edit, const std::vector<Vertex>& vertices, double enough,
  int numberOfRounds, const std::function<bool(Vertex)>& accept)
{
  const OptimizedMesh& mesh = edit.mesh();
  for (int round = 0; round < numberOfRounds; ++round)
  {
    for (const Vertex v : vertices)
    {
      const VertexStar star(mesh, v);
      const double bound = std::min(enough, starQuality(mesh, v)) - Tuning::RoundingOfAngle;
      const double before = unevenness(mesh, v);
      const auto isBetter = [&]() {
        return star.exceeds(mesh.state(v), bound) && unevenness(mesh, v) < before && accept(v);
      };
      Vec3 sum = Vec3::Zero();
      double total = 0;
      mesh.forEachFace(v, [&](Face f) {
        const auto [a, b, c] = mesh.corners(f);
        const double s = squaresOf(mesh, f);
        sum += s * (mesh.position(a) + mesh.position(b) + mesh.position(c) - 3. * mesh.position(v));
        total += 2. * s;
      });
      const Vec3 step = sum / total;
      if (mesh.isFree(v))
      {
        for (const double share : { 1., 0.5, 0.2 })
        {
          if (edit.tryPut(v, mesh.walk(mesh.place(v), share * step), isBetter))
          {
            break;
          }
        }
        continue;
      }
      const double length = step.norm();
      edit.trySlide(v, length, isBetter) || edit.trySlide(v, -length, isBetter) ||
        edit.trySlide(v, 0.3 * length, isBetter) || edit.trySlide(v, -0.3 * length, isBetter);
    }
  }
}
}
