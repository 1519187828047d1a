// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Charts and feature graph as all stages see them: read and checked once, and shared.
#ifndef stipple_Atlas_h
#define stipple_Atlas_h

#include "ChartGraph.h"
#include "CompressedRows.h"
#include "Lazy.h"
#include "Progress.h"
#include "StippleFiltersCoreModule.h"
#include "SurfaceWalk.h"
#include "TriangleIntersections.h"

#include <functional>
#include <initializer_list>
#include <memory>
#include <vector>

namespace stipple
{
class JoinedCreases;

/// Squared length on the surface of a step (du, dv): E du^2 + 2 F du dv + G dv^2.
struct FirstFundamentalForm
{
  float E = 1;
  float F = 0;
  float G = 1;

  Vec2 times(const Vec2& d) const
  {
    return { this->E * d.x() + this->F * d.y(), this->F * d.x() + this->G * d.y() };
  }
  double dot(const Vec2& a, const Vec2& b) const { return this->times(a).dot(b); }
  double squared(const Vec2& d) const { return this->dot(d, d); }
};

/// The neighbours along edges of every vertex.
struct VertexNeighbours
{
  CompressedRows<int> of;                  ///< a vertex
  ElementArray<Vertex, Halfedge> outgoing; ///< the last that leaves it; none if no triangle has it
};

/// Does not change after it is read. What is made when first asked for may be asked for by any
/// thread.
class STIPPLEFILTERSCORE_EXPORT Atlas
{
public:
  using Pointer = std::shared_ptr<const Atlas>;

  ~Atlas();
  /// The atlas of these data sets; the feature graph may be null. Who asks for the same unmodified
  /// data sets while anyone keeps their atlas gets that one, and the charts alone are shared by
  /// atlases of any graph. Modified() of a chart, its points, cells or arrays makes a new one.
  /// Stopped while charts are read, there is none.
  [[nodiscard]] static Status read(vtkPartitionedDataSetCollection* charts,
    vtkPolyData* featureGraph, Pointer& atlas, const Stop& stop = {});
  /// The same surface with another graph of the same sharp edges. Borrows this one for what does
  /// not depend on which backbones they make.
  Pointer withGraph(FeatureGraph graph) const;
  /// How often charts were read in this process.
  static int numberOfReads();

  const AtlasSurface& surface() const { return *this->Surface; }
  const FeatureGraph& graph() const { return this->Graph; }
  /// By backbone.
  const std::vector<BackboneTrace>& traces() const { return this->Traces; }
  const SurfaceTopology& topology() const;
  /// Of the maps to the charts' planes.
  const ElementArray<Face, FirstFundamentalForm>& metric() const;
  /// Sharp edges are its walls.
  const SurfaceWalk& walk() const;
  /// Normals of faces averaged with those about them on the same side of creases; unit length, or
  /// zero.
  const ElementArray<Face, Vec3>& smoothNormals() const;
  const Vec3& smoothNormal(Face face) const { return this->smoothNormals()[face]; }
  const Vec3& smoothNormal(int face) const { return this->smoothNormals()[Face(face)]; }
  /// The same with other walls, the charts' halfedges with 1.
  ElementArray<Face, Vec3> smoothNormalsWith(const std::vector<char>& wall) const;
  /// Where the surface passes through itself, as placesOfIntersections() says; empty if it cannot
  /// tell.
  const std::vector<Box>& selfIntersections() const;
  /// Its creases and boundaries as they go on where seams end.
  const JoinedCreases& joinedCreases() const;
  const VertexNeighbours& vertexNeighbours() const;
  /// As TriangleSurface::vertexHalfedges().
  const ElementArray<Vertex, Halfedge>& vertexHalfedges() const
  {
    return this->Source ? this->Source->Outgoing : this->Outgoing;
  }
  /// The place at an arc length of a backbone, seen from the first side that it has.
  SurfacePlace placeOfBackbone(int backbone, double arcLength) const;
  /// 1 for the charts' halfedges that lie on backbones of these types, 0 for others.
  std::vector<char> halfedgesOn(std::initializer_list<BackboneType> types) const;
  /// The same, on backbones that are marked.
  std::vector<char> halfedgesOn(const std::vector<char>& isMarked) const;
  /// By backbone: 1 for boundaries, and for those that are creases to a mesh with edges as long as
  /// `spacing` says at their middles.
  std::vector<char> creasesTo(const std::function<double(const SurfacePlace&)>& spacing) const;
  /// A point that a triangle uses, as a place.
  SurfacePlace placeOfPoint(int p) const;

private:
  struct Cache;
  Atlas();
  Status readGraph(vtkPolyData* featureGraph);

  const Atlas* Source = nullptr; ///< that this is withGraph() of
  std::shared_ptr<const AtlasSurface> Surface;
  vtkSmartPointer<vtkPolyData> GraphData;
  FeatureGraph Graph;
  std::vector<BackboneTrace> Traces;
  ElementArray<Vertex, Halfedge> Outgoing;
  Lazy<SurfaceTopology> Topology;
  Lazy<ElementArray<Face, FirstFundamentalForm>> Metric;
  Lazy<SurfaceWalk> Walk;
  Lazy<ElementArray<Face, Vec3>> SmoothNormals;
  Lazy<VertexNeighbours> Neighbours;
  Lazy<std::vector<Box>> SelfIntersections;
  Lazy<std::unique_ptr<const JoinedCreases>> Creases;
};
}

#endif
