// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The mesh under optimisation: its connectivity, and the place of every vertex on the surface. It
// is read here; MeshEdit changes it.
#ifndef stipple_OptimizedMesh_h
#define stipple_OptimizedMesh_h

#include "Atlas.h"
#include "DensityField.h"
#include "ElementIds.h"
#include "SampleSet.h"
#include "SpacingRegions.h"
#include "StippleFiltersOptimizationModule.h"

#include <OpenMesh/Core/Mesh/TriConnectivity.hh>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

namespace stipple
{
using Edge = ElementId<struct EdgeElement>; ///< of two halfedges

/// How a vertex may move.
enum class Freedom : char
{
  Surface,  ///< anywhere; also where a seam runs
  Backbone, ///< along its sharp or boundary backbone
  None      ///< corners and constraints, also those on backbones
};

/// A point of the surface.
struct SurfacePoint
{
  SurfacePlace place;
  Vec3 position = Vec3::Zero();
  Vec3 normal = Vec3::Zero(); ///< of the surface, averaged over a few faces about the place
};

/// All that a vertex's moves change.
struct VertexState : SurfacePoint
{
  double density = 1;              ///< of vertices, as wanted at the place
  double arcLength = 0;            ///< on its backbone
  Vec3 otherNormal = Vec3::Zero(); ///< on the other side of its backbone
};

/// A vertex on a backbone. One that slides has its own arc length; this is the place of one that
/// does not.
struct BackboneVertex
{
  Vertex vertex;
  double arcLength = 0;

  friend bool operator==(const BackboneVertex& a, const BackboneVertex& b)
  {
    return a.vertex == b.vertex && a.arcLength == b.arcLength;
  }
};

/// An edge on a sharp or boundary backbone, in its direction.
struct Crease
{
  int backbone = -1; ///< none for an edge that is fixed by itself
  BackboneVertex from;
  BackboneVertex to;
};

/// A triangle that there is, or might be: for each vertex, a halfedge out of it whose triangle, to
/// the left, lies between the same creases there.
using TriangleCorners = std::array<Halfedge, 3>;

/// Ascending, and each once.
template <typename Id>
void makeUnique(std::vector<Id>& ids)
{
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

class STIPPLEFILTERSOPTIMIZATION_EXPORT OptimizedMesh
{
public:
  /// The atlas and the density are borrowed. Fails if the mesh is no manifold, or lacks an edge of
  /// a backbone. Sharp backbones that are rounded off are creases where they are that to edges as
  /// long as the mesh's, or all of them.
  Status build(const stipple::Atlas& atlas, const DensityField& density,
    const std::vector<Sample>& samples, const std::vector<Triangle>& triangles,
    bool allAreCreases = false);
  using Chain = std::vector<BackboneVertex>;
  /// With the vertices of every backbone; one without any is no crease. Where features were
  /// simplified, some are not on it: of these, the first numberOfHeld of the mesh stay where they
  /// are, and all those of a feature that users named.
  Status build(const stipple::Atlas& atlas, const DensityField& density,
    const std::vector<Sample>& samples, const std::vector<Triangle>& triangles,
    std::vector<Chain> chains, int numberOfHeld);
  /// A part of a mesh, on a surface that may go on beyond it: vertices are places on the surface,
  /// of which only those with isMovable move; edges between others are not swapped, nor
  /// made by swaps, and of these, fixedEdges part the surface as creases do. The atlas' backbones
  /// are walls to walks and nothing else.
  Status buildPart(const stipple::Atlas& atlas, const DensityField& density,
    const std::vector<SurfacePlace>& places, const std::vector<char>& isMovable,
    const std::vector<Triangle>& triangles, const std::vector<std::array<int, 2>>& fixedEdges);

  ElementRange<Vertex> vertices() const { return this->State.ids(); }
  ElementRange<Edge> edges() const { return { 0, static_cast<int>(this->Graph.n_edges()) }; }
  ElementRange<Face> faces() const { return { 0, static_cast<int>(this->Graph.n_faces()) }; }

  Vertex from(Halfedge h) const { return Vertex(this->Graph.from_vertex_handle(raw(h)).idx()); }
  Vertex to(Halfedge h) const { return Vertex(this->Graph.to_vertex_handle(raw(h)).idx()); }
  /// About the triangle to the left.
  Halfedge next(Halfedge h) const { return id(this->Graph.next_halfedge_handle(raw(h))); }
  Halfedge previous(Halfedge h) const { return id(this->Graph.prev_halfedge_handle(raw(h))); }
  Halfedge opposite(Halfedge h) const { return id(this->Graph.opposite_halfedge_handle(raw(h))); }
  /// The third vertex of the triangle to the left.
  Vertex apex(Halfedge h) const { return this->to(this->next(h)); }
  Edge edge(Halfedge h) const { return Edge(this->Graph.edge_handle(raw(h)).idx()); }
  Face face(Halfedge h) const { return Face(this->Graph.face_handle(raw(h)).idx()); }
  Halfedge halfedge(Edge e, int side = 0) const
  {
    return id(this->Graph.halfedge_handle(raw(e), static_cast<unsigned int>(side)));
  }
  Halfedge halfedge(Face f) const
  {
    return id(this->Graph.halfedge_handle(OpenMesh::FaceHandle(f.index())));
  }
  Halfedge halfedge(Vertex v) const { return id(this->Graph.halfedge_handle(raw(v))); }
  bool isBoundary(Halfedge h) const { return this->Graph.is_boundary(raw(h)); }
  bool isBoundary(Vertex v) const { return this->Graph.is_boundary(raw(v)); }
  /// Whether a backbone of the graph was one to the mesh at first: a boundary, or sharp, with long
  /// edges beside its width if it is rounded.
  bool isCreaseBackbone(int b) const { return this->IsCreaseBackbone[b] != 0; }
  /// On a sharp or boundary backbone.
  bool isCrease(Edge e) const { return this->CreaseOf[e] >= 0; }
  /// Of an edge that is one.
  const Crease& crease(Edge e) const { return this->Creases[this->CreaseOf[e]]; }
  /// Two triangles, and no crease: all that an edge needs to be swapped but for the geometry.
  bool isSwappable(Edge e) const
  {
    return !this->isCrease(e) && !this->Graph.is_boundary(raw(e)) &&
      !(this->IsPart && this->isBetweenFixed(this->halfedge(e)));
  }
  /// No second edge between two vertices comes of swapping it.
  bool keepsManifold(Edge e) const
  {
    return this->Graph.is_flip_ok(raw(e)) && !(this->IsPart && this->joinsFixed(e));
  }
  int valence(Vertex v) const;
  TriangleCorners triangleCorners(Face f) const
  {
    const Halfedge h = this->halfedge(f);
    return { { h, this->next(h), this->previous(h) } };
  }
  std::array<Vertex, 3> corners(Face f) const
  {
    const Halfedge h = this->halfedge(f);
    return { { this->from(h), this->to(h), this->apex(h) } };
  }
  /// Halfedges out of the four vertices of an edge's two triangles, all in these triangles: the
  /// edge's ends, then the others.
  std::array<Halfedge, 4> wing(Edge e) const
  {
    const Halfedge h = this->halfedge(e);
    const Halfedge g = this->opposite(h);
    return { { h, g, this->previous(h), this->previous(g) } };
  }
  /// Those vertices: the triangles are (a, b, c) and (b, a, d); after a swap, (d, c, a) and
  /// (c, d, b).
  std::array<Vertex, 4> wingVertices(Edge e) const
  {
    const auto h = this->wing(e);
    return { { this->from(h[0]), this->from(h[1]), this->from(h[2]), this->from(h[3]) } };
  }
  /// Calls visit(h) for every halfedge out of v, clockwise.
  template <typename Visit>
  void forEachHalfedge(Vertex v, const Visit& visit) const
  {
    const Halfedge first = this->halfedge(v);
    Halfedge h = first;
    do
    {
      visit(h);
      h = this->next(this->opposite(h));
    } while (h != first);
  }
  /// Calls visit(u) for every vertex that an edge joins to v.
  template <typename Visit>
  void forEachNeighbour(Vertex v, const Visit& visit) const
  {
    this->forEachHalfedge(v, [&](Halfedge h) { visit(this->to(h)); });
  }
  /// Calls visit(h) for every triangle about v, with its halfedge out of v.
  template <typename Visit>
  void forEachCorner(Vertex v, const Visit& visit) const
  {
    this->forEachHalfedge(v, [&](Halfedge h) {
      if (!this->isBoundary(h))
      {
        visit(h);
      }
    });
  }
  /// Calls visit(f) for every triangle about v.
  template <typename Visit>
  void forEachFace(Vertex v, const Visit& visit) const
  {
    this->forEachCorner(v, [&](Halfedge h) { visit(this->face(h)); });
  }

  const VertexState& state(Vertex v) const { return this->State[v]; }
  const Vec3& position(Vertex v) const { return this->State[v].position; }
  const Vec3& normal(Vertex v) const { return this->State[v].normal; }
  const SurfacePlace& place(Vertex v) const { return this->State[v].place; }
  double density(Vertex v) const { return this->State[v].density; }
  double arcLength(Vertex v) const { return this->State[v].arcLength; }
  double arcLength(const BackboneVertex& v) const
  {
    return this->Free[v.vertex] == Freedom::Backbone ? this->State[v.vertex].arcLength
                                                     : v.arcLength;
  }
  Freedom freedom(Vertex v) const { return this->Free[v]; }
  /// Free to go anywhere. Elsewhere, on creases, the surface has no one normal.
  bool isFree(Vertex v) const { return this->Free[v] == Freedom::Surface; }
  int backbone(Vertex v) const { return this->BackboneOf[v]; }
  Vec3 faceNormal(Face f) const;
  double faceArea(Face f) const;
  SurfacePoint pointAt(const SurfacePlace& place) const;
  /// Where a walk from a place along a vector of space ends: where it begins, if that is not
  /// finite.
  SurfacePoint walk(const SurfacePlace& from, const Vec3& step) const;
  /// On the surface, with the mesh's creases as walls.
  const SurfaceWalk& surfaceWalk() const
  {
    return this->OwnWalk ? *this->OwnWalk : this->Atlas->walk();
  }
  /// Of the surface, averaged on either side of these.
  const Vec3& smoothNormal(int face) const
  {
    return (this->OwnNormals ? *this->OwnNormals : this->Atlas->smoothNormals())[Face(face)];
  }
  /// The density is the same everywhere, but for coarse and fine regions.
  bool uniform() const { return this->Field->uniform(); }
  /// From now on, spacing grows in these regions: density() is less there.
  void coarsen(SpacingRegions regions);
  /// In one of these.
  bool isCoarse(Vertex v) const
  {
    return !this->Coarse.empty() &&
      this->Coarse.growthAt(Face(this->place(v).face), this->position(v)) > 1.;
  }
  /// From now on, spacing shrinks in these regions: density() is more there.
  void refine(SpacingRegions regions);
  const SpacingRegions& fineRegions() const { return this->Fine; }
  /// By how much spacing shrinks at a vertex: less than 1 in one of these.
  double fineness(Vertex v) const
  {
    return this->Fine.empty() ? 1.
                              : this->Fine.growthAt(Face(this->place(v).face), this->position(v));
  }
  /// Of vertices, as wanted at a place.
  double densityAt(const SurfacePoint& point) const;

  /// The mean cosine of the angle between a vector, normal to a triangle, and the surface's normals
  /// at its vertices; 1 if they all lie on creases.
  double normalAgreement(
    Vertex a, Vertex b, Vertex c, const Vec3& normal, double lengthOfNormal) const
  {
    double sum = 0;
    int count = 0;
    for (const Vertex v : { a, b, c })
    {
      if (this->isFree(v)) // on a crease the surface has no one normal
      {
        sum += normal.dot(this->normal(v));
        ++count;
      }
    }
    return count > 0 && lengthOfNormal > 0 ? sum / (count * lengthOfNormal) : 1.;
  }
  double normalAgreement(Vertex a, Vertex b, Vertex c, const Vec3& normal) const
  {
    return this->normalAgreement(a, b, c, normal, normal.norm());
  }
  /// The normal of the surface at a vertex on creases, between the two on either side of the
  /// triangle to the left of the halfedge out of the vertex.
  Vec3 normalBeside(Halfedge h) const;
  /// normalAgreement() of a triangle whose vertices all lie on creases.
  double normalAgreementOnCreases(const TriangleCorners& corners, const Vec3& normal) const;
  /// The triangle faces the way the surface does at its vertices, and is not degenerate.
  bool isSound(const TriangleCorners& corners) const;
  bool isSound(Face f) const { return this->isSound(this->triangleCorners(f)); }
  /// It has as good as no area.
  bool isFlat(const TriangleCorners& corners) const;

  std::vector<Triangle> triangles() const;
  std::vector<Sample> samples() const;
  /// The vertices of every backbone in order, with both ends; empty for seams.
  const std::vector<Chain>& chains() const { return this->Chains; }
  /// A position that users named, which must be a vertex.
  bool isConstraint(Vertex v) const { return this->IsConstraint[v] != 0; }
  /// Places of the surface that vertices were at until changes led them, and creases, to this one.
  const std::vector<Vec3>& absorbed(Vertex v) const { return this->Absorbed[v]; }

  /// The same vertices in other triangles, on other chains: some that were not free go where they
  /// are told to, and are, and some that slid on a backbone are where others cross it. Fails as
  /// build() does. Edges and triangles get new ids.
  struct Change
  {
    struct OnBackbone
    {
      Vertex vertex;
      int backbone;
      double arcLength;
    };
    std::vector<std::pair<Vertex, SurfacePoint>> freed;
    std::vector<OnBackbone> onBackbones; ///< that come from elsewhere, and slide unless fixed
    std::vector<Vertex> fixed;
    std::vector<Triangle> triangles;
    std::vector<Chain> chains;
    ElementArray<Vertex, std::vector<Vec3>> absorbed; ///< of all vertices; empty: as before
    int features = 0;                                 ///< that were simplified
    int swaps = 0;                                    ///< and what else was done
  };
  Status rebuild(Change change);
  /// From now on, sharp backbones are none: no walls to walks, and their vertices are free but for
  /// corners, constraints, and those of other creases. Each counts as a feature that was
  /// simplified.
  void giveUp(const std::vector<int>& backbones);
  /// All that was done.
  int numberOfChanges() const { return this->Changes; }
  int numberOfSimplifiedFeatures() const { return this->SimplifiedFeatures; }
  const stipple::Atlas& atlas() const { return *this->Atlas; }

private:
  friend class MeshEdit;
  static OpenMesh::HalfedgeHandle raw(Halfedge h) { return OpenMesh::HalfedgeHandle(h.index()); }
  static OpenMesh::VertexHandle raw(Vertex v) { return OpenMesh::VertexHandle(v.index()); }
  static OpenMesh::EdgeHandle raw(Edge e) { return OpenMesh::EdgeHandle(e.index()); }
  static Halfedge id(OpenMesh::HalfedgeHandle h) { return Halfedge(h.idx()); }

  /// Swapped, the edge would join two vertices that do not move: the rest of the mesh may have that
  /// edge.
  bool joinsFixed(Edge e) const
  {
    const auto [a, b, c, d] = this->wingVertices(e);
    return this->Free[c] == Freedom::None && this->Free[d] == Freedom::None;
  }
  bool isBetweenFixed(Halfedge h) const
  {
    return this->Free[this->from(h)] == Freedom::None && this->Free[this->to(h)] == Freedom::None;
  }
  Status begin(
    const stipple::Atlas& atlas, const DensityField& density, const std::vector<Sample>& samples);
  /// Once creases are known.
  void placeVertices(const std::vector<Sample>& samples);
  /// With the samples of each backbone of the graph.
  void findCreaseBackbones(const std::vector<std::vector<int>>& chains, bool allAreCreases);
  /// Length of edges that the number of samples makes, before there are any, where the density
  /// is 1.
  double spacingAtUnitDensity() const;
  /// Walks and normals of its own, which only creases of the mesh part.
  void partByCreases();
  /// By point of the surface.
  std::vector<char> fixedNodes() const;
  Status connect(const std::vector<Triangle>& triangles);
  Status markCreases(std::vector<Chain> chains);
  void updateDensity();
  void put(Vertex v, const SurfacePoint& there);
  void putOnBackbone(Vertex v, double arcLength);
  void findOtherNormal(Vertex v);

  const stipple::Atlas* Atlas = nullptr;
  const DensityField* Field = nullptr;
  SpacingRegions Coarse;
  SpacingRegions Fine;
  OpenMesh::TriConnectivity Graph; // halfedges without coordinates
  std::vector<Sample> Original;
  ElementArray<Vertex, VertexState> State;
  ElementArray<Vertex, Freedom> Free;
  ElementArray<Vertex, int> BackboneOf; // or -1
  ElementArray<Vertex, char> IsConstraint;
  ElementArray<Vertex, std::vector<Vec3>> Absorbed;
  ElementArray<Edge, int> CreaseOf; // in Creases, or -1
  std::vector<Crease> Creases;
  std::vector<Chain> Chains;
  std::vector<char> IsCreaseBackbone; // of the graph's
  /// Where some of the surface's creases are none to this mesh; a mesh and its copies have the
  /// same.
  std::shared_ptr<const SurfaceWalk> OwnWalk;
  std::shared_ptr<const ElementArray<Face, Vec3>> OwnNormals;
  int Changes = 0;
  int SimplifiedFeatures = 0;
  bool IsPart = false;
};

/// The vertices of chains alone.
STIPPLEFILTERSOPTIMIZATION_EXPORT std::vector<std::vector<int>> idsOf(
  const std::vector<OptimizedMesh::Chain>& chains);
}

#endif
