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
}
