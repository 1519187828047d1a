// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshCreation.h"

#include "AttributeTransfer.h"
#include "ChartStitching.h"
#include "MessageText.h"
#include "PolyDataConversion.h"
#include "ReportingThread.h"
#include "UserArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <set>
#include <unordered_map>
#include <unordered_set>

namespace stipple
{
namespace
{
/// So many charts are triangulated in the plane one by one if their triangles do not fit, then all.
constexpr std::size_t MostChartsInPlane = 4;

Status checkSamples(const FeatureGraph& graph, const std::vector<Sample>& samples)
{
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const Sample& s = samples[i];
    if (s.kind == SampleKind::Backbone &&
      (s.backbone < 0 || s.backbone >= static_cast<int>(graph.backbones.size())))
    {
      return Status::error("Sample " + std::to_string(i) + " lies on backbone " +
        std::to_string(s.backbone) +
        ", which the feature graph does not have: pass charts and feature graph that the samples "
        "were made from.");
    }
  }
  return Status::success();
}

/// Every chart's outline must be one closed chain of three samples at least.
Status checkChartGraphs(const std::vector<ChartGraph>& charts)
{
  for (std::size_t c = 0; c < charts.size(); ++c)
  {
    std::size_t links = 0;
    for (const ChartGraph::Segment& s : charts[c].segments)
    {
      links += s.onBoundary;
    }
    if (charts[c].boundary.size() < 3 || charts[c].boundary.size() != links)
    {
      return Status::tooFewPoints("Chart " + std::to_string(c) + " has " +
        countOf(static_cast<long long>(charts[c].boundary.size()), "sample", "samples") +
        " in a row on its outline, where a closed chain of at least three is needed; use more "
        "points.");
    }
  }
  return Status::success();
}

/// The mesh has one vertex a sample, no two triangles back to back, and the topology of the
/// surface. Where two triangles are, the fault names a chart that a sample would help: three are
/// too few for a closed component.
Status checkTopology(const Atlas& atlas, const std::vector<Sample>& samples,
  const std::vector<Triangle>& triangles, MeshFault& fault)
{
  TriangleSurface mesh;
  mesh.points.resize(samples.size());
  mesh.triangles = triangles;
  mesh.connect();
  std::vector<char> used(samples.size(), 0);
  for (const Triangle& t : triangles)
  {
    used[t[0]] = used[t[1]] = used[t[2]] = 1;
  }
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    if (!used[i])
    {
      return Status::error("Sample " + std::to_string(i) +
        " is in no triangle: a node or a backbone of it bounds no chart; pass charts, feature "
        "graph and "
        "samples of one pipeline.");
    }
  }
  for (int h = 0; h < static_cast<int>(mesh.twin.size()); ++h)
  {
    const int g = mesh.twin[h];
    if (g >= 0 && mesh.head(nextHalfedge(h)) == mesh.head(nextHalfedge(g)))
    {
      fault.chart = Chart(atlas.surface().faceChart[samples[mesh.head(nextHalfedge(h))].face]);
      return Status::tooFewPoints("The samples " + std::to_string(mesh.tail(h)) + ", " +
        std::to_string(mesh.head(h)) + " and " + std::to_string(mesh.head(nextHalfedge(h))) +
        " would carry two triangles back to back; use more points.");
    }
  }
  const SurfaceTopology topology = mesh.topology();
  if (!(topology == atlas.topology()))
  {
    return Status::tooFewPoints("The samples do not carry the surface's topology (" +
      differenceOf(topology, atlas.topology()) + "); use more points.");
  }
  return Status::success();
}
}

Status createMesh(const Atlas& atlas, const std::vector<Sample>& samples,
  std::vector<Triangle>& triangles, const Progress& progress, MeshFault* wanted)
{
  const AtlasSurface& surface = atlas.surface();
  const FeatureGraph& graph = atlas.graph();
  MeshFault unwanted;
  MeshFault& fault = wanted ? *wanted : unwanted;
  fault = {};
  Status status = checkSamples(graph, samples);
  if (!status.ok())
  {
    return status;
  }
  const std::vector<ChartGraph> chartGraphs =
    buildChartGraphs(surface, graph, atlas.traces(), samples);
  status = checkChartGraphs(chartGraphs);
  if (!status.ok())
  {
    return status;
  }
  const BackboneIntervals intervals(graph, samplesByBackbone(graph, samples));
  const int numberOfCharts = surface.numberOfCharts();
  std::vector<std::vector<int>> interior(numberOfCharts);
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    if (samples[i].kind == SampleKind::Interior || samples[i].kind == SampleKind::Constraint)
    {
      interior[surface.faceChart[samples[i].face]].push_back(static_cast<int>(i));
    }
  }
  if (!report(progress, 0.05))
  {
    return Status::aborted();
  }

  std::vector<ChartTriangulation> meshes(numberOfCharts);
  std::vector<std::optional<Status>> outcome(numberOfCharts);
  const auto triangulate = [&](int c, DelaunayMetric metric, const Stop& stop) {
    meshes[c] = {};
    outcome[c] = triangulateChart(surface, c, chartGraphs[c], atlas.traces(), graph, intervals,
      samples, interior[c], metric, meshes[c], stop);
  };
  status = reportingFor(numberOfCharts, progress, 0.05, 0.6, [&](int c, const Stop& stop) {
    triangulate(c, DelaunayMetric::Surface, stop);
    if (!outcome[c]->ok() && !isAsked(stop))
    {
      triangulate(c, DelaunayMetric::Plane, stop);
    }
  });
  if (!status.ok())
  {
    return status;
  }
  for (int c = 0; c < numberOfCharts; ++c)
  {
    if (!outcome[c]->ok())
    {
      fault.chart = Chart(c);
      return *outcome[c];
    }
  }
  const Stop stop = [&progress] { return !report(progress, 0.6); };
  std::set<Chart> inPlane;
  for (bool isLast = false;;)
  {
    ElementArray<Label, char> hasEdge;
    fault = {};
    status =
      stitchCharts(surface, graph, intervals, meshes, samples, triangles, hasEdge, fault, stop);
    status = status.ok() ? checkTopology(atlas, samples, triangles, fault) : status;
    if (status.code() != StatusCode::TooFewPoints || isLast)
    {
      break;
    }
    // Where triangles by lengths on the surface do not fit together, those of the plane may.
    isLast = !fault.chart.valid() || inPlane.size() == MostChartsInPlane ||
      !inPlane.insert(fault.chart).second;
    for (int c = 0; c < numberOfCharts; ++c)
    {
      if (isLast || Chart(c) == fault.chart)
      {
        triangulate(c, DelaunayMetric::Plane, stop);
        if (!outcome[c]->ok())
        {
          fault = { Chart(c), {} };
          return *outcome[c];
        }
      }
    }
  }
  if (!status.ok())
  {
    return status;
  }
  return report(progress, 0.8) ? Status::success() : Status::aborted();
}

std::vector<std::vector<int>> backboneChains(
  const FeatureGraph& graph, const std::vector<Sample>& samples)
{
  std::vector<std::vector<int>> chains = samplesByBackbone(graph, samples);
  std::unordered_map<int, int> nodeSample;
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    if (samples[i].kind == SampleKind::Corner)
    {
      nodeSample[samples[i].surfacePoint] = static_cast<int>(i);
    }
  }
  for (std::size_t b = 0; b < chains.size(); ++b)
  {
    std::vector<int>& chain = chains[b];
    const Backbone& backbone = graph.backbones[b];
    if (backbone.closed)
    {
      if (!chain.empty())
      {
        chain.push_back(chain.front());
      }
      continue;
    }
    const auto first = nodeSample.find(backbone.points.front());
    const auto last = nodeSample.find(backbone.points.back());
    if (first != nodeSample.end())
    {
      chain.insert(chain.begin(), first->second);
    }
    if (last != nodeSample.end())
    {
      chain.push_back(last->second);
    }
  }
  return chains;
}

Status readFeatureLines(vtkPolyData* lines, const FeatureGraph& graph, vtkIdType numberOfPoints,
  std::vector<std::vector<int>>& chains)
{
  const std::string remedy = "pass output port 1 of the filter that made the mesh";
  chains.assign(graph.backbones.size(), {});
  vtkDataArray* backbones = nullptr;
  if (Status status = findArray(lines->GetCellData(), "BackboneId", 1, lines->GetNumberOfLines(),
        "The feature lines", remedy, backbones);
      !status.ok())
  {
    return status;
  }
  if (Status status = checkCells(lines->GetLines(), numberOfPoints, "the feature lines");
      !status.ok())
  {
    return status;
  }
  vtkIdType size;
  const vtkIdType* ids;
  for (vtkIdType line = 0; line < lines->GetNumberOfLines(); ++line)
  {
    const int b =
      indexBelow(backbones->GetComponent(line, 0), static_cast<int>(graph.backbones.size()));
    if (b < 0)
    {
      return badId(
        backbones, line, "line " + std::to_string(line), static_cast<int>(graph.backbones.size()));
    }
    if (graph.backbones[b].type == BackboneType::Seam) // its edges may have been swapped away
    {
      continue;
    }
    lines->GetLines()->GetCellAtId(line, size, ids);
    if (!chains[b].empty())
    {
      return Status::error(
        "The feature lines have two lines of backbone " + std::to_string(b) + ": " + remedy + ".");
    }
    chains[b].assign(ids, ids + size);
  }
  return Status::success();
}

vtkSmartPointer<vtkPolyData> meshToPolyData(const stipple::Atlas& atlas,
  const std::vector<Sample>& samples, const std::vector<Triangle>& triangles)
{
  const AtlasSurface& surface = atlas.surface();
  auto mesh = toPolyData(samples, surface); // points, provenance and the arrays of samples
  mesh->SetVerts(nullptr);
  mesh->SetPolys(toPolyData(std::vector<Vec3>(), triangles)->GetPolys());
  std::vector<SurfacePlace> places(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    places[i] = { samples[i].face, samples[i].bary };
  }
  transferAttributes(surface, atlas.walk(), places, triangles, mesh);
  return mesh;
}

vtkSmartPointer<vtkPolyData> featureLines(const FeatureGraph& graph,
  const std::vector<std::vector<int>>& chains, vtkPolyData* mesh, bool withSeams)
{
  auto output = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkIntArray> type;
  type->SetName("BackboneType");
  vtkNew<vtkIntArray> closed;
  closed->SetName("Closed");
  vtkNew<vtkIntArray> id;
  id->SetName("BackboneId");
  std::unordered_set<std::uint64_t> edges;
  const auto key = [](vtkIdType a, vtkIdType b) {
    return (static_cast<std::uint64_t>(std::min(a, b)) << 32) |
      static_cast<std::uint64_t>(std::max(a, b));
  };
  vtkIdType size;
  const vtkIdType* corner;
  for (vtkIdType t = 0; withSeams && t < mesh->GetNumberOfPolys(); ++t)
  {
    mesh->GetPolys()->GetCellAtId(t, size, corner);
    for (vtkIdType k = 0; k < size; ++k)
    {
      edges.insert(key(corner[k], corner[(k + 1) % size]));
    }
  }
  for (std::size_t b = 0; b < chains.size(); ++b)
  {
    const Backbone& backbone = graph.backbones[b];
    const bool isSeam = backbone.type == BackboneType::Seam;
    if (chains[b].size() < 2 || (isSeam && !withSeams))
    {
      continue;
    }
    // A seam ends where stitching had to swap its edge away, and goes on behind.
    std::vector<std::vector<vtkIdType>> pieces(1);
    for (int p : chains[b])
    {
      if (isSeam && !pieces.back().empty() && edges.count(key(pieces.back().back(), p)) == 0)
      {
        pieces.emplace_back();
      }
      pieces.back().push_back(p);
    }
    for (const auto& piece : pieces)
    {
      if (piece.size() > 1)
      {
        lines->InsertNextCell(static_cast<vtkIdType>(piece.size()), piece.data());
        type->InsertNextValue(static_cast<int>(backbone.type));
        closed->InsertNextValue(piece.front() == piece.back() ? 1 : 0);
        id->InsertNextValue(static_cast<int>(b));
      }
    }
  }
  output->SetPoints(mesh->GetPoints());
  output->SetLines(lines);
  output->GetCellData()->AddArray(type);
  output->GetCellData()->AddArray(closed);
  output->GetCellData()->AddArray(id);
  return output;
}
}
