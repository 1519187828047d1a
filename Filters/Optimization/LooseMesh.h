// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// A mesh taken apart, with places of its vertices: vertices go from where they are needed least to
// where they are needed most, and their number stays.
#ifndef stipple_LooseMesh_h
#define stipple_LooseMesh_h

#include "BoxGrid.h"
#include "LooseTriangles.h"
#include "Relaxation.h"
#include "StippleFiltersOptimizationModule.h"

#include <optional>

namespace stipple
{
class STIPPLEFILTERSOPTIMIZATION_EXPORT LooseMesh
{
public:
  /// Borrows the mesh, which stays as it is. The tolerance, in spacings, is how far the surface may
  /// move for a triangle that has no angle.
  LooseMesh(const OptimizedMesh& mesh, double tolerance);

  /// Puts what was freed where triangles are largest; nothing if all is creases.
  OptimizedMesh::Change finish();

protected:
  const Vec3& position(int v) const { return this->Place[Vertex(v)].position; }
  const Vec3& position(Vertex v) const { return this->Place[v].position; }
  double length(Vertex a, Vertex b) const { return (this->position(a) - this->position(b)).norm(); }
  Vec3 normal(const Triangle& t) const;
  /// The smallest.
  static double angleOf(const std::array<Vec3, 3>& p);
  double angle(const Triangle& t) const;
  double spacingAt(Vertex v) const { return this->Spacing.at(v); }
  /// Whether a triangle turns its back on the surface at its free corners, or on how it was.
  bool isTurnedOver(const Triangle& before, const Triangle& after) const;
  /// No triangle about v is folded onto a neighbour after v has gone to u, unless it was.
  bool staysOpen(Vertex v, Vertex u) const;
  /// Pairs of triangles that count as passing through each other: those without a free corner, as
  /// on thin walls, which no move will part again, or all.
  enum class Pairs
  {
    Held,
    All
  };
  /// No more pairs pass through each other after some triangles have been replaced than now.
  bool staysApart(
    const std::vector<int>& triangles, const std::vector<Triangle>& after, Pairs which);
  /// The same of held pairs after v has gone to u, and after a swap of an edge between two
  /// triangles.
  bool collapseStaysApart(Vertex v, Vertex u);
  bool swapStaysApart(Vertex p, Vertex q);
  /// The same of all pairs after a vertex, which is in no triangle, has split an edge.
  bool splitStaysApart(Vertex a, Vertex b, Vertex middle);
  /// From a place to the nearest triangle that is left about v when v has gone to u.
  double distanceToRest(const Vec3& p, Vertex v, Vertex u) const;
  /// The nearest place to one in space, less far from it than that, at which straight walks from
  /// vertices end.
  std::optional<SurfacePoint> placeNear(
    const Vec3& target, const std::array<Vertex, 4>& from, double farthest) const;
  void collapse(Vertex v, Vertex u);
  bool hasSpare() { return !this->Freed.empty() || this->freeOne(); }
  /// A vertex from elsewhere, for another place.
  Vertex takeSpare(const SurfacePoint& place, bool isFree);
  /// Under the wanted density, up to a factor: 3 sqrt(3) / 2 times the square of the spacing, where
  /// that is 1, of a regular triangle.
  double areaOf(const Triangle& t) const;
  /// The edges between two triangles, no creases, with a free end, of so many largest triangles:
  /// first those with the largest two.
  std::vector<VertexPair> widestEdges(std::size_t numberOfTriangles) const;
  /// Of an edge with a free end, on the surface.
  SurfacePoint middle(Vertex a, Vertex b) const;
  /// Not where one of them is: a walk from a crease may begin on the wrong side of it, and end
  /// there.
  bool isBetween(const Vec3& place, Vertex a, Vertex b) const;

  const OptimizedMesh& Mesh;
  const VertexSpacing Spacing;
  const double Tolerance; // over the spacing
  LooseTriangles Now;
  ElementArray<Vertex, SurfacePoint> Place;
  ElementArray<Vertex, double> Density; // as wanted where they come from
  ElementArray<Vertex, char> IsFree;
  ElementArray<Vertex, std::vector<Vec3>> Absorbed; // places of what has gone there
  std::vector<Vertex> Freed;
  std::vector<Vertex> Placed; // of those that were
  std::vector<Vertex> Joined; // where spare vertices went
  std::vector<Vertex> Fixed;
  std::vector<OptimizedMesh::Change::OnBackbone> OnBackbones;
  int NumberOfFeatures = 0; // that were simplified
  int NumberOfSwaps = 0;    // and vertices that went elsewhere

private:
  /// Frees a vertex inside faces, where triangles stay best.
  bool freeOne();
  /// Collapses that cost least, of vertices inside faces, some of which are looked at; the best
  /// last.
  std::vector<std::pair<double, VertexPair>> spareVertices() const;
  /// A free vertex among free ones, where spacing has not shrunk.
  bool isInside(Vertex v) const;
  /// How good triangles about an inner vertex and its neighbours, all free, are if it goes to one
  /// of these: their smallest angle, less what the distance is worth by which the surface moves.
  double angleWithout(Vertex v, Vertex u) const;
  PlacedTriangle placed(const Triangle& t) const;
  /// Those about triangles, as these are now.
  BoxGrid& boxes();
  bool isHeld(const Triangle& t) const;
  /// Pairs that pass through each other, both of some triangles, or one of them and one of all but
  /// those that are left out.
  int crossings(const std::vector<Triangle>& some, const std::vector<int>& leftOut, Pairs which);

  std::optional<BoxGrid> Boxes;                     // once asked
  std::vector<std::pair<double, VertexPair>> Spare; // collapses that cost little, the best last
  bool HasLookedForSpare = false;
};
}

#endif
