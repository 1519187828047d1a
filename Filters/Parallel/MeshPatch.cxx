// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshPatch.h"

#include "Atlas.h"
#include "CellLocator.h"
#include "DensityField.h"
#include "FeatureGraph.h"
#include "OptimizedMesh.h"
#include "PolyDataConversion.h"
#include "TriangleDistance.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

namespace stipple
{
namespace
{
static_assert(sizeof(Vec3) == 3 * sizeof(double));

template <typename T>
void writeVector(const std::vector<T>& values, Bytes& bytes)
{
  const auto size = static_cast<long long>(values.size());
  const auto* head = reinterpret_cast<const char*>(&size);
  bytes.insert(bytes.end(), head, head + sizeof size);
  const auto* data = reinterpret_cast<const char*>(values.data());
  bytes.insert(bytes.end(), data, data + values.size() * sizeof(T));
}

template <typename T>
void readVector(const Bytes& bytes, std::size_t& at, std::vector<T>& values)
{
  long long size = 0;
  std::memcpy(&size, bytes.data() + at, sizeof size);
  at += sizeof size;
  values.resize(static_cast<std::size_t>(size));
  if (size > 0)
  {
    std::memcpy(static_cast<void*>(values.data()), bytes.data() + at, values.size() * sizeof(T));
  }
  at += values.size() * sizeof(T);
}

/// The surface of a patch, as an atlas of one chart without parameters: what walks on it needs
/// none.
Status makeAtlas(const TriangleSurface& surface, const std::set<std::array<int, 2>>& creases,
  Atlas::Pointer& atlas)
{
  vtkSmartPointer<vtkPolyData> chart = toPolyData(surface.points, surface.triangles);
  vtkNew<vtkDoubleArray> uv;
  uv->SetName("UV");
  uv->SetNumberOfComponents(2);
  uv->SetNumberOfTuples(chart->GetNumberOfPoints());
  uv->Fill(0.);
  chart->GetPointData()->AddArray(uv);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("SurfacePointId");
  for (vtkIdType p = 0; p < chart->GetNumberOfPoints(); ++p)
  {
    ids->InsertNextValue(p);
  }
  chart->GetPointData()->AddArray(ids);
  vtkNew<vtkIdTypeArray> cells;
  cells->SetName("SourceCellId");
  for (vtkIdType f = 0; f < chart->GetNumberOfCells(); ++f)
  {
    cells->InsertNextValue(f);
  }
  chart->GetCellData()->AddArray(cells);
  vtkNew<vtkDoubleArray> extent;
  extent->SetName("ChartExtent");
  extent->SetNumberOfComponents(2);
  extent->InsertNextTuple2(1., 1.);
  chart->GetFieldData()->AddArray(extent);
  vtkNew<vtkPartitionedDataSet> set;
  set->SetPartition(0, chart);
  vtkNew<vtkPartitionedDataSetCollection> charts;
  charts->SetPartitionedDataSet(0, set);
  FeatureGraph graph;
  graph.isCorner.assign(surface.points.size(), 0);
  for (const auto& [p, q] : creases)
  {
    Backbone backbone;
    backbone.points = { p, q };
    graph.backbones.push_back(backbone);
  }
  return Atlas::read(charts, toPolyData(graph, surface.points), atlas);
}

/// Parts of a mesh, or of a surface, as one: points by their ids.
class Merged
{
public:
  void add(const std::vector<long long>& ids) { this->Ids.insert(ids.begin(), ids.end()); }
  void number()
  {
    for (const long long id : this->Ids)
    {
      this->NumberOf.emplace_hint(
        this->NumberOf.end(), id, static_cast<int>(this->NumberOf.size()));
    }
  }
  int operator[](long long id) const { return this->NumberOf.at(id); }
  std::vector<long long> ids() const { return { this->Ids.begin(), this->Ids.end() }; }
  std::size_t size() const { return this->Ids.size(); }

private:
  std::set<long long> Ids;
  std::map<long long, int> NumberOf;
};

/// Finds the face of a surface that is nearest to a point, of several the first: VTK's locator
/// answers with any of them, as its threads happen to sort.
class FaceLocator
{
public:
  explicit FaceLocator(const TriangleSurface& surface)
    : Surface(surface)
    , Locator(surface.points, surface.triangles)
    , About(surface.points.size())
  {
    for (int f = 0; f < surface.numberOfFaces(); ++f)
    {
      for (const int p : surface.triangles[f])
      {
        this->About[p].push_back(f);
      }
    }
  }

  SurfacePlace find(const Vec3& x) const
  {
    // All that are as near have a point in common with the one that is found.
    const auto face = static_cast<int>(this->Locator.nearest(x).cell);
    int first = face;
    double least = this->distance(x, first);
    for (const int p : this->Surface.triangles[static_cast<std::size_t>(face)])
    {
      for (const int f : this->About[p])
      {
        const double there = this->distance(x, f);
        if (there < least || (there == least && f < first))
        {
          least = there;
          first = f;
        }
      }
    }
    const Face found(first);
    return { first,
      clampedBarycentric(barycentricInSpace(x, this->Surface.point(found, 0),
        this->Surface.point(found, 1), this->Surface.point(found, 2))) };
  }

private:
  double distance(const Vec3& x, int f) const
  {
    return squaredDistanceToTriangle(
      x, this->Surface.point(f, 0), this->Surface.point(f, 1), this->Surface.point(f, 2));
  }
  const TriangleSurface& Surface;
  CellLocator Locator;
  std::vector<std::vector<int>> About; // faces, by point
};

/// Makes copies of points where triangles meet in a point only, as they may at the rim of a patch.
/// Returns what each copy is of.
std::vector<int> splitFans(std::vector<Triangle>& triangles, int numberOfPoints)
{
  const HalfedgeTwins twin = halfedgeTwins(triangles);
  // Corners, by their halfedges, in one fan are one set.
  std::vector<int> parent(twin.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto find = [&](int i) {
    while (parent[i] != i)
    {
      parent[i] = parent[parent[i]];
      i = parent[i];
    }
    return i;
  };
  for (const Halfedge h : twin.ids())
  {
    if (twin[h].valid())
    {
      const int a = find(h.index());
      const int b = find(nextHalfedge(twin[h]).index());
      parent[std::max(a, b)] = std::min(a, b);
    }
  }
  std::vector<int> fanOf(static_cast<std::size_t>(numberOfPoints), -1);
  std::map<int, int> copyOf; // by fan
  std::vector<int> copies;
  std::vector<Triangle> result = triangles;
  for (const Halfedge h : twin.ids())
  {
    const int p = triangles[faceOf(h).index()][cornerOf(h)];
    const int fan = find(h.index());
    fanOf[p] = fanOf[p] < 0 ? fan : fanOf[p];
    if (fanOf[p] == fan)
    {
      continue;
    }
    const auto [found, isNew] =
      copyOf.try_emplace(fan, numberOfPoints + static_cast<int>(copies.size()));
    if (isNew)
    {
      copies.push_back(p);
    }
    result[faceOf(h).index()][cornerOf(h)] = found->second;
  }
  triangles = std::move(result);
  return copies;
}
}

void PatchPart::write(long long number, Bytes& bytes) const
{
  writeVector(std::vector<long long>{ number, this->block }, bytes);
  writeVector(this->id, bytes);
  writeVector(this->position, bytes);
  writeVector(this->isMovable, bytes);
  writeVector(this->movesLater, bytes);
  writeVector(this->triangles, bytes);
  writeVector(this->lines, bytes);
  writeVector(this->surfaceId, bytes);
  writeVector(this->surfacePosition, bytes);
  writeVector(this->density, bytes);
  writeVector(this->surfaceTriangles, bytes);
  writeVector(this->source, bytes);
  writeVector(this->creases, bytes);
}

void PatchPart::read(const Bytes& bytes, std::size_t& at, long long& number)
{
  std::vector<long long> head;
  readVector(bytes, at, head);
  number = head[0];
  this->block = static_cast<int>(head[1]);
  readVector(bytes, at, this->id);
  readVector(bytes, at, this->position);
  readVector(bytes, at, this->isMovable);
  readVector(bytes, at, this->movesLater);
  readVector(bytes, at, this->triangles);
  readVector(bytes, at, this->lines);
  readVector(bytes, at, this->surfaceId);
  readVector(bytes, at, this->surfacePosition);
  readVector(bytes, at, this->density);
  readVector(bytes, at, this->surfaceTriangles);
  readVector(bytes, at, this->source);
  readVector(bytes, at, this->creases);
}

void HealedPatch::write(long long number, Bytes& bytes) const
{
  writeVector(std::vector<long long>{ number, this->patch }, bytes);
  writeVector(this->id, bytes);
  writeVector(this->position, bytes);
  writeVector(this->isMovable, bytes);
  writeVector(this->movesLater, bytes);
  writeVector(this->place, bytes);
  writeVector(this->triangles, bytes);
  writeVector(this->trianglePlace, bytes);
}

void HealedPatch::read(const Bytes& bytes, std::size_t& at, long long& number)
{
  std::vector<long long> head;
  readVector(bytes, at, head);
  number = head[0];
  this->patch = head[1];
  readVector(bytes, at, this->id);
  readVector(bytes, at, this->position);
  readVector(bytes, at, this->isMovable);
  readVector(bytes, at, this->movesLater);
  readVector(bytes, at, this->place);
  readVector(bytes, at, this->triangles);
  readVector(bytes, at, this->trianglePlace);
}

Status optimizePatch(
  const std::vector<PatchPart>& parts, const OptimizerOptions& options, HealedPatch& healed)
{
  Merged points;
  Merged surfacePoints;
  for (const PatchPart& part : parts)
  {
    points.add(part.id);
    surfacePoints.add(part.surfaceId);
  }
  points.number();
  surfacePoints.number();
  healed.id = points.ids();
  healed.position.assign(points.size(), Vec3::Zero());
  healed.isMovable.assign(points.size(), 0);
  healed.movesLater.assign(points.size(), 0);
  std::vector<Triangle> triangles;
  std::set<std::array<int, 2>> lines;
  TriangleSurface surface;
  surface.points.assign(surfacePoints.size(), Vec3::Zero());
  std::vector<double> densities(surfacePoints.size(), 1.);
  std::vector<std::array<int, 2>> source;
  std::set<std::array<int, 2>> creases;
  for (const PatchPart& part : parts)
  {
    for (std::size_t i = 0; i < part.id.size(); ++i)
    {
      const int p = points[part.id[i]];
      healed.position[p] = part.position[i];
      healed.isMovable[p] = healed.isMovable[p] != 0 || part.isMovable[i] != 0 ? 1 : 0;
      healed.movesLater[p] = healed.movesLater[p] != 0 || part.movesLater[i] != 0 ? 1 : 0;
    }
    for (const auto& t : part.triangles)
    {
      triangles.push_back({ points[part.id[t[0]]], points[part.id[t[1]]], points[part.id[t[2]]] });
    }
    for (const auto& line : part.lines)
    {
      lines.insert({ { points[part.id[line[0]]], points[part.id[line[1]]] } });
    }
    for (std::size_t i = 0; i < part.surfaceId.size(); ++i)
    {
      const int p = surfacePoints[part.surfaceId[i]];
      surface.points[p] = part.surfacePosition[i];
      densities[p] = part.density[i];
    }
    for (const auto& t : part.surfaceTriangles)
    {
      surface.triangles.push_back({ surfacePoints[part.surfaceId[t[0]]],
        surfacePoints[part.surfaceId[t[1]]], surfacePoints[part.surfaceId[t[2]]] });
    }
    source.insert(source.end(), part.source.begin(), part.source.end());
    for (const auto& crease : part.creases)
    {
      const auto [p, q] = std::minmax(
        { surfacePoints[part.surfaceId[crease[0]]], surfacePoints[part.surfaceId[crease[1]]] });
      creases.insert({ { p, q } });
    }
  }
  // At the rim, creases may have no triangle, or none that is joined to the others at their ends.
  surface.connect();
  const ElementArray<Vertex, Halfedge> outgoing = surface.vertexHalfedges();
  for (auto crease = creases.begin(); crease != creases.end();)
  {
    const Vertex p((*crease)[0]);
    const Vertex q((*crease)[1]);
    const bool isEdge = findHalfedge(surface, outgoing, p, q).valid() ||
      findHalfedge(surface, outgoing, q, p).valid();
    crease = isEdge ? std::next(crease) : creases.erase(crease);
  }
  Atlas::Pointer atlas;
  if (Status status = makeAtlas(surface, creases, atlas); !status.ok())
  {
    return status;
  }
  const FaceLocator locator(surface);
  std::vector<SurfacePlace> places;
  for (const Vec3& x : healed.position)
  {
    places.push_back(locator.find(x));
  }
  // A line between copies is an edge on the rim, and stays anyway.
  std::vector<char> isMovable = healed.isMovable;
  const std::vector<int> copies = splitFans(triangles, static_cast<int>(points.size()));
  for (const int p : copies)
  {
    if (isMovable[p] != 0)
    {
      return Status::internal("The mesh of blocks touches itself in point " +
        std::to_string(healed.id[p]) + ", on a border.");
    }
    places.push_back(places[p]);
    isMovable.push_back(0);
  }
  DensityField density;
  density.setAtPoints(std::move(densities));
  OptimizedMesh mesh;
  if (Status status = mesh.buildPart(
        *atlas, density, places, isMovable, triangles, { lines.begin(), lines.end() });
      !status.ok())
  {
    return status;
  }
  if (Status status = optimizeMesh(mesh, options, {}); !status.ok())
  {
    return status;
  }
  for (const Vertex v : mesh.vertices())
  {
    if (v.index() >= static_cast<int>(points.size()))
    {
      break;
    }
    const SurfacePlace& place = mesh.place(v);
    if (healed.isMovable[v.index()] != 0)
    {
      healed.position[v.index()] = mesh.position(v);
    }
    const std::array<int, 2>& from = source[place.face];
    healed.place.push_back(
      { from[0], from[1], { { place.bary[0], place.bary[1], place.bary[2] } } });
  }
  for (Triangle t : mesh.triangles())
  {
    for (int& p : t)
    {
      p = p < static_cast<int>(points.size()) ? p : copies[p - points.size()];
    }
    if (healed.isMovable[t[0]] + healed.isMovable[t[1]] + healed.isMovable[t[2]] == 0)
    {
      continue; // it stays
    }
    healed.triangles.push_back(t);
    const SurfacePlace middle =
      locator.find((healed.position[t[0]] + healed.position[t[1]] + healed.position[t[2]]) / 3.);
    const std::array<int, 2>& from = source[static_cast<std::size_t>(middle.face)];
    healed.trianglePlace.push_back({ from[0], from[1], {} });
  }
  return Status::success();
}
}
