// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceCache.h"

#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"

namespace stipple
{
Status SurfaceCache::update(vtkPartitionedDataSetCollection* charts, vtkPolyData* featureGraph)
{
  // The data sets are held, so that no new one can turn up at the address of one that is gone.
  Key key;
  const unsigned int n = charts ? charts->GetNumberOfPartitionedDataSets() : 0;
  for (unsigned int c = 0; c < n; ++c)
  {
    vtkPolyData* chart = chartOf(charts, c);
    key.emplace_back(chart, chart ? chart->GetMTime() : 0);
  }
  key.emplace_back(featureGraph, featureGraph ? featureGraph->GetMTime() : 0);
  if (this->Walk && key == this->KeyOfContents)
  {
    return Status::success();
  }
  this->Walk.reset();
  ++this->Generation;
  Status status = readAtlas(charts, this->Surface);
  if (status.ok())
  {
    status = readFeatureGraph(featureGraph, this->Graph);
  }
  if (status.ok())
  {
    status = traceBackbones(this->Surface, this->Graph, this->Traces);
  }
  if (!status.ok())
  {
    return status;
  }
  std::vector<char> wall(this->Surface.twin.size(), 0);
  for (std::size_t b = 0; b < this->Traces.size(); ++b)
  {
    for (int side = 0; side < 2 && this->Graph.backbones[b].type == BackboneType::Sharp; ++side)
    {
      for (int h : this->Traces[b].halfedge[side])
      {
        if (h >= 0)
        {
          wall[h] = 1;
        }
      }
    }
  }
  this->smoothNormals(wall);
  this->findNeighbours();
  this->Walk = std::make_unique<SurfaceWalk>(this->Surface, std::move(wall));
  this->Topology = this->Surface.topology();
  this->KeyOfContents = std::move(key);
  return Status::success();
}

void SurfaceCache::smoothNormals(const std::vector<char>& wall)
{
  const int n = this->Surface.numberOfFaces();
  std::vector<double> area(n);
  this->SmoothNormal.resize(n);
  for (int f = 0; f < n; ++f)
  {
    this->SmoothNormal[f] = this->Surface.faceNormal(f);
    area[f] = this->Surface.faceArea(f);
  }
  for (int round = 0; round < 3; ++round)
  {
    const std::vector<Vec3> before = this->SmoothNormal;
    for (int f = 0; f < n; ++f)
    {
      Vec3 sum = area[f] * before[f];
      for (int h = 3 * f; h < 3 * f + 3; ++h)
      {
        const int g = this->Surface.twin[h];
        if (g >= 0 && !wall[h])
        {
          sum += area[g / 3] * before[g / 3];
        }
      }
      const double length = sum.norm();
      this->SmoothNormal[f] = length > 0 ? Vec3(sum / length) : before[f];
    }
  }
}

void SurfaceCache::findNeighbours()
{
  const AtlasSurface& surface = this->Surface;
  const int n = static_cast<int>(surface.points.size());
  const int halfedges = static_cast<int>(surface.twin.size());
  const auto forEachEdge = [&](const auto& visit) {
    for (int h = 0; h < halfedges; ++h)
    {
      if (h > surface.twin[h])
      {
        visit(surface.tail(h), surface.head(h));
      }
    }
  };
  this->Outgoing.assign(n, -1);
  for (int h = 0; h < halfedges; ++h)
  {
    this->Outgoing[surface.tail(h)] = h;
  }
  this->NeighbourBegin.assign(n + 1, 0);
  forEachEdge([&](int p, int q) {
    ++this->NeighbourBegin[p + 1];
    ++this->NeighbourBegin[q + 1];
  });
  for (int p = 0; p < n; ++p)
  {
    this->NeighbourBegin[p + 1] += this->NeighbourBegin[p];
  }
  this->Neighbours.resize(this->NeighbourBegin.back());
  std::vector<int> next = this->NeighbourBegin;
  forEachEdge([&](int p, int q) {
    this->Neighbours[next[p]++] = q;
    this->Neighbours[next[q]++] = p;
  });
}

SurfacePlace SurfaceCache::placeOfBackbone(int backbone, double arcLength) const
{
  const BackboneTrace& trace = this->Traces[backbone];
  const BackboneTrace::Place place = trace.locate(arcLength);
  const int side = trace.hasSide(0) ? 0 : 1;
  return { trace.face(place, side), trace.bary(place, side) };
}

SurfacePlace SurfaceCache::placeOfPoint(int p) const
{
  const int h = this->Outgoing[p];
  return { h / 3, Vec3::Unit(h % 3) };
}
}
