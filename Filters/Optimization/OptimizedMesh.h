// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The mesh under optimisation: its connectivity, and the place of every vertex on the surface.
#ifndef stipple_OptimizedMesh_h
#define stipple_OptimizedMesh_h

#include "CoarseRegions.h"
#include "DensityField.h"
#include "SampleSet.h"
#include "StippleFiltersOptimizationModule.h"
#include "SurfaceCache.h"

#include <OpenMesh/Core/Mesh/TriConnectivity.hh>

#include <algorithm>
#include <array>

namespace stipple
{
/// How a vertex may move.
enum class Freedom : char
{
  Surface,  ///< anywhere; also where a seam runs
  Backbone, ///< along its sharp or boundary backbone
  None      ///< corners and constraints, also those on backbones
};

/// A place on the surface, and what is asked there most.
struct Footing
{
  SurfacePlace place;
  Vec3 position = Vec3::Zero();
  Vec3 normal = Vec3::Zero(); ///< of the surface, averaged over a few faces about the place
};

/// Ascending, and each once.
inline void makeUnique(std::vector<int>& ids)
{
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

class STIPPLEFILTERSOPTIMIZATION_EXPORT OptimizedMesh
{
public:
  using Connectivity = OpenMesh::TriConnectivity; // halfedges without coordinates
  using Halfedge = OpenMesh::HalfedgeHandle;
  using Vertex = OpenMesh::VertexHandle;

  /// The atlas and the density are borrowed. Fails if the mesh is no manifold, or lacks an edge of
  /// a backbone.
  Status build(const SurfaceCache& atlas, const DensityField& density,
    const std::vector<Sample>& samples, const std::vector<Triangle>& triangles);

  int numberOfVertices() const { return static_cast<int>(this->Position.size()); }
  int numberOfFaces() const { return static_cast<int>(this->Graph.n_faces()); }
  int numberOfEdges() const { return static_cast<int>(this->Graph.n_edges()); }
  const Connectivity& graph() const { return this->Graph; }
  const Vec3& position(int v) const { return this->Position[v]; }
  const Vec3& position(Vertex v) const { return this->Position[v.idx()]; }
  /// Of the surface, averaged over a few faces about the vertex's place.
  const Vec3& normal(int v) const { return this->Normal[v]; }
  const SurfacePlace& place(int v) const { return this->Place[v]; }
  double density(int v) const { return this->Density[v]; }
  /// But for coarse regions.
  bool uniform() const { return this->Field->uniform(); }
  /// From now on, spacing grows in these regions: density() is less there.
  void coarsen(CoarseRegions regions);
  Freedom freedom(int v) const { return this->Free[v]; }
  bool isFeature(int edge) const { return this->Feature[edge] != 0; }
  /// Both triangles and no feature: all that an edge needs to be swapped but for the geometry.
  bool isSwappable(int edge) const
  {
    return !this->Feature[edge] && !this->Graph.is_boundary(OpenMesh::EdgeHandle(edge));
  }
  int valence(int v) const;
  std::array<int, 3> corners(int face) const
  {
    const Halfedge h = this->Graph.halfedge_handle(OpenMesh::FaceHandle(face));
    return { { this->Graph.from_vertex_handle(h).idx(), this->Graph.to_vertex_handle(h).idx(),
      this->Graph.to_vertex_handle(this->Graph.next_halfedge_handle(h)).idx() } };
  }
  /// Calls visit(h) for every halfedge out of v, clockwise.
  template <typename Visit>
  void forEachHalfedge(int v, const Visit& visit) const
  {
    const Halfedge first = this->Graph.halfedge_handle(Vertex(v));
    Halfedge h = first;
    do
    {
      visit(h);
      h = this->Graph.next_halfedge_handle(this->Graph.opposite_halfedge_handle(h));
    } while (h != first);
  }
  /// Calls visit(u) for every vertex that an edge joins to v.
  template <typename Visit>
  void forEachNeighbour(int v, const Visit& visit) const
  {
    this->forEachHalfedge(v, [&](Halfedge h) { visit(this->Graph.to_vertex_handle(h).idx()); });
  }
  /// Calls visit(f) for every triangle about v.
  template <typename Visit>
  void forEachFace(int v, const Visit& visit) const
  {
    this->forEachHalfedge(v, [&](Halfedge h) {
      if (!this->Graph.is_boundary(h))
      {
        visit(this->Graph.face_handle(h).idx());
      }
    });
  }
  Vec3 faceNormal(int face) const
  {
    const auto t = this->corners(face);
    const Vec3& p = this->position(t[0]);
    return (this->position(t[1]) - p).cross(this->position(t[2]) - p).normalized();
  }
  std::vector<Triangle> triangles() const;
  std::vector<Sample> samples() const;

  /// Swaps an edge if no second edge between two vertices, no fold and no degenerate triangle comes
  /// of it.
  bool swap(int edge);
  /// Swaps without asking; for taking back a swap.
  void forceSwap(int edge) { this->Graph.flip(OpenMesh::EdgeHandle(edge)); }
  /// The mean cosine of the angle between a vector, normal to a triangle, and the surface's normals
  /// at its vertices; 1 if they all lie on creases.
  double agreement(int a, int b, int c, const Vec3& normal) const;
  /// The same for a triangle whose vertices all lie on creases, where the surface has a normal on
  /// each side: with the sides that agree most. 1 if they are all corners.
  double agreementOnCreases(int a, int b, int c, const Vec3& normal) const;
  /// Triangles that agree less are folded over. Over a rim thinner than a triangle the agreement is
  /// small for good reason; in a fold it is about -1.
  static constexpr double minimumAgreement() { return 0.1; }
  /// The triangle (a, b, c) faces the way the surface does at its vertices, and is not degenerate.
  bool isSound(int a, int b, int c) const;

  /// Moves vertices by steps of space (free vertices) and to arc lengths (backbone vertices), all
  /// at once. Where that makes a triangle unsound, the steps of its vertices are halved, at last
  /// refused.
  void move(std::vector<Vec3>& step, const std::vector<double>& arcLength);
  Footing footing(int v) const { return { this->Place[v], this->Position[v], this->Normal[v] }; }
  /// Where a walk from a place along a vector of space ends.
  Footing footing(const SurfacePlace& from, const Vec3& step) const;
  /// Puts a vertex that is free on the surface there.
  void put(int v, const Footing& there);
  /// Puts a vertex back to where it stood once.
  void putBack(int v, const Footing& there, double arcLength)
  {
    this->put(v, there);
    this->ArcLength[v] = arcLength;
    this->lookBehind(v);
  }
  /// Puts a vertex there, unless it is not free on the surface or accept(), asked with the vertex
  /// there, says no: then nothing is changed, and it returns false.
  template <typename Accept>
  bool tryOut(int v, const Footing& there, const Accept& accept)
  {
    if (this->Free[v] != Freedom::Surface)
    {
      return false;
    }
    const Footing old = this->footing(v);
    this->stand(v, there);
    if (accept())
    {
      this->put(v, there);
      return true;
    }
    this->stand(v, old);
    return false;
  }
  /// The same along a vertex's backbone, but never past half the way to its neighbours there.
  template <typename Accept>
  bool trySlide(int v, double step, const Accept& accept)
  {
    if (!this->hasRoom(v, step))
    {
      return false;
    }
    const double old = this->ArcLength[v];
    this->placeOnBackbone(v, old + step);
    if (accept())
    {
      return true;
    }
    this->placeOnBackbone(v, old);
    return false;
  }

  /// Backbone vertices in order, with both ends; empty for seams.
  const std::vector<std::vector<int>>& chains() const { return this->Chain; }
  const SurfaceCache& atlas() const { return *this->Atlas; }
  double arcLength(int v) const { return this->ArcLength[v]; }
  int backbone(int v) const { return this->BackboneOf[v]; }

private:
  Status connect(const std::vector<Triangle>& triangles);
  Status markFeatures();
  void placeVertex(int v, const SurfacePlace& place);
  double densityAt(const SurfacePlace& place, const Vec3& position) const;
  /// All but the density, which attempts do not ask for.
  void stand(int v, const Footing& there)
  {
    this->Place[v] = there.place;
    this->Position[v] = there.position;
    this->Normal[v] = there.normal;
  }
  void lookBehind(int v);
  bool hasRoom(int v, double step) const;
  void placeOnBackbone(int v, double arcLength);
  bool isSoundFace(int f) const;

  const SurfaceCache* Atlas = nullptr;
  const DensityField* Field = nullptr;
  CoarseRegions Coarse;
  Connectivity Graph;
  std::vector<Sample> Original;
  std::vector<SurfacePlace> Place;
  std::vector<Vec3> Position;
  std::vector<Vec3> Normal;
  std::vector<Vec3> Behind; // the normal on the other side of a vertex's backbone
  std::vector<double> Density;
  std::vector<Freedom> Free;
  std::vector<int> BackboneOf;
  std::vector<double> ArcLength;
  std::vector<char> Feature; // by edge
  std::vector<std::vector<int>> Chain;
  struct
  {
    std::vector<SurfacePlace> place;
    std::vector<Vec3> position;
    std::vector<Vec3> normal;
    std::vector<Vec3> behind;
    std::vector<double> arcLength;
  } Before; // the last move
};
}

#endif
