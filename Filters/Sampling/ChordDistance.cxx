// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ChordDistance.h"

#include "Geometry.h"

#include "vtkIdList.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStaticPointLocator.h"

#include <algorithm>
#include <limits>

namespace stipple
{
ChordDistance::ChordDistance(
  const AtlasSurface& surface, const ChartGraph& graph, const std::vector<Sample>& samples)
  : Neighbours(graph.vertices.size())
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const ChartGraph::Vertex& v : graph.vertices)
  {
    const Sample& s = samples[static_cast<std::size_t>(v.sample)];
    this->Ends.push_back(surface.position(s.face, s.bary));
    points->InsertNextPoint(this->Ends.back().data());
  }
  for (const ChartGraph::Segment& s : graph.segments)
  {
    this->Neighbours[s.first].push_back(s.second);
    this->Neighbours[s.second].push_back(s.first);
  }
  if (!this->Ends.empty())
  {
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    this->Locator->SetDataSet(data);
    this->Locator->BuildLocator();
  }
}

ChordDistance::~ChordDistance() = default;

double ChordDistance::squared(const Vec3& place) const
{
  constexpr int Nearest = 4;
  double least = std::numeric_limits<double>::max();
  if (this->Ends.empty())
  {
    return least;
  }
  vtkNew<vtkIdList> ids;
  this->Locator->FindClosestNPoints(Nearest, place.data(), ids);
  for (const vtkIdType id : *ids)
  {
    const auto v = static_cast<std::size_t>(id);
    for (const int u : this->Neighbours[v])
    {
      least = std::min(
        least, (nearestOnSegment(place, this->Ends[v], this->Ends[u]) - place).squaredNorm());
    }
  }
  return least;
}
}
