// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Atlas.h"

#include "JoinedCreases.h"
#include "ParallelFor.h"

#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cassert>
#include <list>

namespace stipple
{
/// The atlases that somebody keeps, by the data sets that they are of.
struct Atlas::Cache
{
  // What is read from a data set holds it: none at its address can be another.
  using Key = std::vector<std::pair<vtkDataObject*, vtkMTimeType>>;
  template <typename T>
  struct Entry
  {
    Key key;
    std::weak_ptr<const T> value;
  };
  std::mutex Mutex;
  std::list<Entry<AtlasSurface>> Surfaces;
  std::list<Entry<Atlas>> Atlases;
  std::atomic<int> Reads = 0;

  static Cache& instance()
  {
    static Cache cache;
    return cache;
  }

  template <typename T>
  static std::shared_ptr<const T> find(std::list<Entry<T>>& entries, const Key& key)
  {
    entries.remove_if([](const Entry<T>& e) { return e.value.expired(); });
    for (const Entry<T>& e : entries)
    {
      if (e.key == key)
      {
        return e.value.lock();
      }
    }
    return nullptr;
  }
};

Atlas::Atlas() = default;
Atlas::~Atlas() = default;

Status Atlas::read(vtkPartitionedDataSetCollection* charts, vtkPolyData* featureGraph,
  Pointer& atlas, const Stop& stop)
{
  Cache& cache = Cache::instance();
  const std::lock_guard<std::mutex> lock(cache.Mutex);
  Cache::Key key;
  const unsigned int n = charts ? charts->GetNumberOfPartitionedDataSets() : 0;
  for (unsigned int c = 0; c < n; ++c)
  {
    vtkPolyData* chart = chartOf(charts, c);
    key.emplace_back(chart, chart ? chart->GetMTime() : 0);
  }
  std::shared_ptr<const AtlasSurface> surface = Cache::find(cache.Surfaces, key);
  if (!surface)
  {
    atlas.reset(); // before the new one is made: there need not be room for both
    auto fresh = std::make_shared<AtlasSurface>();
    ++cache.Reads;
    if (Status status = readAtlas(charts, *fresh, stop); !status.ok())
    {
      return status;
    }
    surface = std::move(fresh);
    cache.Surfaces.push_back({ key, surface });
  }
  key.emplace_back(featureGraph, featureGraph ? featureGraph->GetMTime() : 0);
  if (Pointer known = Cache::find(cache.Atlases, key))
  {
    atlas = std::move(known);
    return Status::success();
  }
  atlas.reset();
  const std::shared_ptr<Atlas> fresh(new Atlas);
  fresh->Surface = std::move(surface);
  if (Status status = fresh->readGraph(featureGraph); !status.ok())
  {
    return status;
  }
  cache.Atlases.push_back({ std::move(key), fresh });
  atlas = fresh;
  return Status::success();
}

Atlas::Pointer Atlas::withGraph(FeatureGraph graph) const
{
  const std::shared_ptr<Atlas> result(new Atlas);
  result->Source = this->Source ? this->Source : this;
  result->Surface = this->Surface;
  result->GraphData = this->GraphData;
  result->Graph = std::move(graph);
  const Status status =
    traceBackbones(*this->Surface, this->vertexHalfedges(), result->Graph, result->Traces);
  assert(status.ok()); // they run along edges as before
  static_cast<void>(status);
  return result;
}

int Atlas::numberOfReads()
{
  return Cache::instance().Reads;
}

Status Atlas::readGraph(vtkPolyData* featureGraph)
{
  this->GraphData = featureGraph;
  if (Status status = readFeatureGraph(featureGraph, *this->Surface, this->Graph); !status.ok())
  {
    return status;
  }
  this->Outgoing = this->Surface->vertexHalfedges();
  return traceBackbones(*this->Surface, this->Outgoing, this->Graph, this->Traces);
}

const SurfaceTopology& Atlas::topology() const
{
  if (this->Source)
  {
    return this->Source->topology();
  }
  return this->Topology.get([this] { return this->Surface->topology(); });
}

const ElementArray<Face, FirstFundamentalForm>& Atlas::metric() const
{
  if (this->Source)
  {
    return this->Source->metric();
  }
  return this->Metric.get([this] {
    const AtlasSurface& s = *this->Surface;
    ElementArray<Face, FirstFundamentalForm> result(s.triangles.size());
    parallelFor(s.faces(), [&](Face f) {
      const Vec2 a = s.cornerUV(f, 1) - s.cornerUV(f, 0);
      const Vec2 b = s.cornerUV(f, 2) - s.cornerUV(f, 0);
      const Vec3 p = s.point(f, 1) - s.point(f, 0);
      const Vec3 q = s.point(f, 2) - s.point(f, 0);
      const double det = cross2(a, b);
      if (det == 0)
      {
        result[f] = { 0, 0, 0 };
        return;
      }
      const Vec3 du = (p * b.y() - q * a.y()) / det;
      const Vec3 dv = (q * a.x() - p * b.x()) / det;
      result[f] = { static_cast<float>(du.dot(du)), static_cast<float>(du.dot(dv)),
        static_cast<float>(dv.dot(dv)) };
    });
    return result;
  });
}

std::vector<char> Atlas::halfedgesOn(std::initializer_list<BackboneType> types) const
{
  std::vector<char> isMarked(this->Traces.size(), 0);
  for (std::size_t b = 0; b < isMarked.size(); ++b)
  {
    isMarked[b] =
      std::find(types.begin(), types.end(), this->Graph.backbones[b].type) != types.end() ? 1 : 0;
  }
  return this->halfedgesOn(isMarked);
}

std::vector<char> Atlas::halfedgesOn(const std::vector<char>& isMarked) const
{
  std::vector<char> isOn(this->Surface->twin.size(), 0);
  for (std::size_t b = 0; b < this->Traces.size(); ++b)
  {
    if (isMarked[b] == 0)
    {
      continue;
    }
    for (const std::vector<int>& side : this->Traces[b].halfedge)
    {
      for (const int h : side)
      {
        if (h >= 0)
        {
          isOn[h] = 1;
        }
      }
    }
  }
  return isOn;
}

std::vector<char> Atlas::creasesTo(const std::function<double(const SurfacePlace&)>& spacing) const
{
  std::vector<char> result(this->Traces.size(), 0);
  for (std::size_t b = 0; b < result.size(); ++b)
  {
    const Backbone& backbone = this->Graph.backbones[b];
    const bool depends = backbone.width > 0 || backbone.pitch > 0;
    const double length = depends
      ? spacing(this->placeOfBackbone(static_cast<int>(b), 0.5 * this->Traces[b].length()))
      : 0.;
    result[b] = backbone.isCreaseTo(length) ? 1 : 0;
  }
  return result;
}

const SurfaceWalk& Atlas::walk() const
{
  if (this->Source)
  {
    return this->Source->walk();
  }
  return this->Walk.get(
    [this] { return SurfaceWalk(*this->Surface, this->halfedgesOn({ BackboneType::Sharp })); });
}

const ElementArray<Face, Vec3>& Atlas::smoothNormals() const
{
  if (this->Source)
  {
    return this->Source->smoothNormals();
  }
  return this->SmoothNormals.get(
    [this] { return this->smoothNormalsWith(this->halfedgesOn({ BackboneType::Sharp })); });
}

ElementArray<Face, Vec3> Atlas::smoothNormalsWith(const std::vector<char>& wall) const
{
  const AtlasSurface& s = *this->Surface;
  ElementArray<Face, double> area(s.triangles.size());
  ElementArray<Face, Vec3> normal(s.triangles.size());
  parallelFor(s.faces(), [&](Face f) {
    normal[f] = s.faceNormal(f);
    area[f] = s.faceArea(f);
  });
  for (int round = 0; round < 3; ++round)
  {
    const ElementArray<Face, Vec3> before = normal;
    parallelFor(s.faces(), [&](Face f) {
      Vec3 sum = area[f] * before[f];
      for (const Halfedge h : halfedgesOf(f))
      {
        const Halfedge g = s.twin[h];
        if (g.valid() && !wall[h.index()])
        {
          sum += area[faceOf(g)] * before[faceOf(g)];
        }
      }
      const double length = sum.norm();
      normal[f] = length > 0 ? Vec3(sum / length) : before[f];
    });
  }
  return normal;
}

const std::vector<Box>& Atlas::selfIntersections() const
{
  if (this->Source)
  {
    return this->Source->selfIntersections();
  }
  return this->SelfIntersections.get([this] {
    return placesOfIntersections(this->Surface->points, this->Surface->triangles)
      .value_or(std::vector<Box>());
  });
}

const JoinedCreases& Atlas::joinedCreases() const
{
  return *this->Creases.get([this] { return std::make_unique<const JoinedCreases>(*this); });
}

const VertexNeighbours& Atlas::vertexNeighbours() const
{
  if (this->Source)
  {
    return this->Source->vertexNeighbours();
  }
  return this->Neighbours.get([this] {
    const AtlasSurface& s = *this->Surface;
    const int n = s.numberOfVertices();
    VertexNeighbours result;
    result.of = CompressedRows<int>(n, [&s](const auto& add) {
      for (const Halfedge h : s.halfedges())
      {
        if (h > s.twin[h])
        {
          add(s.tail(h).index(), s.head(h).index());
          add(s.head(h).index(), s.tail(h).index());
        }
      }
    });
    result.outgoing = ElementArray<Vertex, Halfedge>(n);
    for (const Halfedge h : s.halfedges())
    {
      result.outgoing[s.tail(h)] = h;
    }
    return result;
  });
}

SurfacePlace Atlas::placeOfBackbone(int backbone, double arcLength) const
{
  const BackboneTrace& trace = this->Traces[backbone];
  const BackboneTrace::Place place = trace.locate(arcLength);
  const int side = trace.hasSide(0) ? 0 : 1;
  return { trace.face(place, side), trace.bary(place, side) };
}

SurfacePlace Atlas::placeOfPoint(int p) const
{
  const Halfedge h = this->vertexNeighbours().outgoing[Vertex(p)];
  return { faceOf(h).index(), Vec3::Unit(cornerOf(h)) };
}
}
