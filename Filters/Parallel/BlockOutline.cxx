// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BlockOutline.h"

#include "CutSurface.h"
#include "FeatureDetection.h"
#include "PolyDataConversion.h"
#include "RegionArrays.h"

#include "vtkCellData.h"
#include "vtkConformalAtlas.h"
#include "vtkControlMap.h"
#include "vtkDataArray.h"
#include "vtkGeometryRemesher.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRemeshOptimizer.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

namespace stipple
{
namespace
{
/// Densities at points, from an array of importances.
Status readDensity(vtkPolyData* data, vtkGeometryRemesher* remesher, std::vector<double>& density)
{
  if (remesher->GetImportance() == vtkControlMap::UNIFORM ||
    !remesher->GetOptimizer()->GetFollowDensity())
  {
    return Status::success();
  }
  const char* name = remesher->GetImportanceArrayName();
  vtkDataArray* ofPoints = name ? data->GetPointData()->GetArray(name) : nullptr;
  vtkDataArray* ofCells = name ? data->GetCellData()->GetArray(name) : nullptr;
  if (remesher->GetImportance() != vtkControlMap::ARRAY || (!ofPoints && !ofCells))
  {
    return Status::error(
      "The importance over blocks is uniform or that of an array that all pieces "
      "have: put what you want to follow into one.");
  }
  const auto n = static_cast<std::size_t>(data->GetNumberOfPoints());
  std::vector<double> sum(n, 0.);
  std::vector<int> count(n, 0);
  if (ofPoints)
  {
    for (std::size_t p = 0; p < n; ++p)
    {
      sum[p] = ofPoints->GetComponent(static_cast<vtkIdType>(p), 0);
      count[p] = 1;
    }
  }
  else
  {
    const TriangleSurface surface = fromPolyData(data);
    for (int f = 0; f < surface.numberOfFaces(); ++f)
    {
      for (const int p : surface.triangles[f])
      {
        sum[p] += ofCells->GetComponent(f, 0);
        ++count[p];
      }
    }
  }
  for (std::size_t p = 0; p < n; ++p)
  {
    const double value = sum[p] / std::max(1, count[p]);
    if (!std::isfinite(value))
    {
      return Status::error(
        "The array '" + std::string(name) + "' has a value that is no finite number.");
    }
    density.push_back(std::pow(std::max(0., value), remesher->GetGamma()));
  }
  return Status::success();
}

}

Status outlineBlock(
  const SurfaceBlock& block, vtkGeometryRemesher* remesher, double diagonal, BlockOutline& outline)
{
  outline = {};
  if (Status status = readDensity(block.data, remesher, outline.density); !status.ok())
  {
    return status;
  }
  TriangleSurface window = fromPolyData(block.data);
  window.connect();
  const double share = diagonal / std::max(1e-300, window.boundingBoxDiagonal());
  std::vector<int> cells(static_cast<std::size_t>(window.numberOfFaces()));
  for (std::size_t f = 0; f < cells.size(); ++f)
  {
    cells[f] = static_cast<int>(f);
  }
  CutSurface surface(window, std::move(cells));
  FeatureDetectionOptions options;
  options.angle = remesher->GetFeatureAngle();
  options.minimumLength = share * remesher->GetAtlas()->GetMinimumFeatureLength();
  options.longLength *= share;
  options.roundedWidth = 0; // what is found here is kept, however short edges are
  detectFeatures(surface, options);
  if (const char* name = remesher->GetAtlas()->GetRegionArrayName())
  {
    vtkAbstractArray* labels = nullptr;
    if (Status status = findRegions(block.data, name, labels); !status.ok())
    {
      return status;
    }
    const std::vector<int> region = numberRegions(labels);
    for (const Halfedge h : surface.halfedges())
    {
      if (!surface.isBoundary(h) &&
        region[faceOf(h).index()] != region[faceOf(surface.twin[h]).index()])
      {
        surface.setKeep(h, Keep::Border);
      }
    }
  }
  std::vector<char> hasFeature(window.points.size(), 0);
  const auto isOwn = [&](Halfedge h) { return faceOf(h).index() < block.numberOfOwn; };
  const auto isOpen = [&](Halfedge h) { return surface.isBoundary(h) || !isOwn(surface.twin[h]); };
  for (const Halfedge h : surface.halfedges())
  {
    if (!isOwn(h))
    {
      continue;
    }
    const int p = surface.tail(h).index();
    const int q = surface.head(h).index();
    if (surface.isFeature(h) && (isOpen(h) || h < surface.twin[h]))
    {
      if (surface.sharp[h] != 0)
      {
        outline.creases.push_back({ { p, q } });
      }
      if (!isOpen(h))
      {
        hasFeature[p] = hasFeature[q] = 1;
      }
    }
  }
  for (const Face f : surface.faces())
  {
    if (f.index() >= block.numberOfOwn)
    {
      break;
    }
    double mean = 1;
    if (!outline.density.empty())
    {
      mean = 0;
      for (int k = 0; k < 3; ++k)
      {
        mean += outline.density[surface.vertex(f, k).index()] / 3.;
      }
    }
    outline.wanted += mean * surface.faceArea(f);
    for (const Halfedge h : halfedgesOf(f))
    {
      if (!isOpen(h))
      {
        continue;
      }
      OpenEdge edge;
      for (int end = 0; end < 2; ++end)
      {
        const int p = (end == 0 ? surface.tail(h) : surface.head(h)).index();
        edge.point[end] = block.pointId[p];
        std::copy_n(surface.points[p].data(), 3, edge.x[end].begin());
        edge.density[end] = outline.density.empty() ? 1. : outline.density[p];
      }
      edge.block = block.number;
      edge.isCrease = surface.isFeature(h) ? 1 : 0;
      edge.hasFeature = hasFeature[surface.tail(h).index()] != 0 ? 1 : 0;
      outline.openEdges.push_back(edge);
    }
  }
  return Status::success();
}

std::vector<std::array<long long, 2>> findSlivers(
  const SurfaceBlock& block, const BlockOutline& outline, double edgeLength, bool isDown)
{
  /// Boxes of blocks reach three edges beyond: their triangles are known to neighbours.
  const double longest = 2.5 * edgeLength;
  const double leastArea = 2. * std::sqrt(3.) / 4. * edgeLength * edgeLength;
  const double leastWidth = edgeLength / 3.;
  TriangleSurface surface = fromPolyData(block.data);
  surface.connect();
  std::set<std::array<int, 2>> creases;
  for (const auto& [p, q] : outline.creases)
  {
    creases.insert({ { std::min(p, q), std::max(p, q) } });
  }
  const auto isCrease = [&](Halfedge h) {
    const int p = surface.tail(h).index();
    const int q = surface.head(h).index();
    return creases.count({ { std::min(p, q), std::max(p, q) } }) > 0;
  };
  std::vector<std::array<long long, 2>> result;
  std::vector<char> isDone(static_cast<std::size_t>(block.numberOfOwn), 0);
  for (int f = 0; f < block.numberOfOwn; ++f)
  {
    if (isDone[f] != 0)
    {
      continue;
    }
    std::vector<int> part(1, f);
    isDone[f] = 1;
    double area = 0;
    double around = 0;
    Vec3 least = surface.point(f, 0);
    Vec3 most = least;
    std::map<int, std::array<double, 2>> shared; // by block: lengths of edges, no creases first
    for (std::size_t i = 0; i < part.size(); ++i)
    {
      area += surface.faceArea(part[i]);
      for (const Halfedge h : halfedgesOf(Face(part[i])))
      {
        const Vec3& x = surface.point(surface.tail(h));
        least = least.cwiseMin(x);
        most = most.cwiseMax(x);
        const Halfedge g = surface.twin[h];
        const int other = g.valid() ? faceOf(g).index() : -1;
        if (other >= 0 && other < block.numberOfOwn && !isCrease(h))
        {
          if (isDone[other] == 0)
          {
            isDone[other] = 1;
            part.push_back(other);
          }
          continue;
        }
        around += surface.edgeLength(h);
        if (other >= block.numberOfOwn)
        {
          shared[block.owner[other]][isCrease(h) ? 1 : 0] += surface.edgeLength(h);
        }
      }
    }
    const bool isSmall = area < leastArea || 2. * area < leastWidth * 0.5 * around;
    if (!isSmall || (most - least).norm() > longest ||
      static_cast<int>(part.size()) == block.numberOfOwn)
    {
      continue;
    }
    int to = -1;
    for (const auto& [neighbour, length] : shared)
    {
      if ((!isDown || neighbour < block.number) && (to < 0 || length > shared[to]))
      {
        to = neighbour;
      }
    }
    for (const int t : part)
    {
      if (to >= 0)
      {
        result.push_back({ { block.triangleId[t], to } });
      }
    }
  }
  return result;
}
}
