// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CoarsePlaces.h"

#include "MeshOverlaps.h"
#include "MeshQuality.h"
#include "PolyDataConversion.h"
#include "SampleSet.h"
#include "SurfaceDeviation.h"
#include "Tuning.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <set>

namespace stipple
{
std::vector<CoarsePlace> coarsePlaces(const TriangleSurface& mesh, const std::vector<char>& isFree,
  const std::function<std::vector<Box>()>& known, const Stop& stop)
{
  const auto meanEdge = [&](Face f) {
    double sum = 0;
    for (const Halfedge h : halfedgesOf(f))
    {
      sum += mesh.edgeLength(h);
    }
    return sum / 3.;
  };
  std::vector<CoarsePlace> places;
  for (const MeshOverlap& overlap : findOverlaps(mesh, known, stop))
  {
    const auto [f, g] = overlap.faces;
    places.push_back({ overlap.position, 0.5 * (meanEdge(f) + meanEdge(g)), true, overlap.faces });
  }
  for (const Face f : mesh.faces())
  {
    if (isTimeToAsk(f.index()) && isAsked(stop))
    {
      break;
    }
    const Triangle& t = mesh.triangles[f.index()];
    if (std::any_of(t.begin(), t.end(), [&](int p) { return isFree[p] != 0; }) &&
      measureTriangle(mesh, f).smallestAngle < SmallestGoodAngle)
    {
      const Vec3 sum = mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]];
      places.push_back({ sum / 3., meanEdge(f), false, { { f, f } } });
    }
  }
  return places;
}

Status addSizePlaces(vtkPolyData* mesh, const Atlas& atlas, double share, const Progress& progress,
  vtkDoubleArray* overlapping, vtkDoubleArray* poor, CoarsePlaceCount& count)
{
  count = {};
  vtkDataArray* kind = mesh->GetPointData()->GetArray("SampleKind");
  std::vector<char> isFree(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  for (std::size_t p = 0; p < isFree.size(); ++p)
  {
    isFree[p] = kind &&
        kind->GetComponent(static_cast<vtkIdType>(p), 0) ==
          static_cast<double>(SampleKind::Interior)
      ? 1
      : 0;
  }
  const auto isStopped = [&] { return !report(progress, 0.); };
  const std::vector<CoarsePlace> places = coarsePlaces(
    fromPolyData(mesh), isFree, [&] { return atlas.selfIntersections(); }, isStopped);
  std::set<Face> triangles;
  for (const CoarsePlace& place : places)
  {
    triangles.insert(place.faces.begin(), place.faces.end());
    ++(place.isOverlap ? count.overlaps : count.poor);
    if (vtkDoubleArray* rows = place.isOverlap ? overlapping : poor)
    {
      const Vec3& p = place.position;
      rows->InsertNextTuple4(p.x(), p.y(), p.z(), share * place.edgeLength);
    }
  }
  count.triangles = static_cast<int>(triangles.size());
  return isStopped() ? Status::aborted() : Status::success();
}

Status visibleDistance(
  vtkPolyData* mesh, const Atlas& atlas, const Progress& progress, double& distance)
{
  const double diagonal = atlas.surface().boundingBoxDiagonal();
  const double visible = Tuning::VisibleDistance * diagonal;
  DeviationBounds bounds;
  const Status status =
    surfaceDeviation(fromPolyData(mesh), atlas.surface(), 0.1 * visible, progress, bounds);
  distance = status.ok() && bounds.upper > visible ? bounds.upper / diagonal : 0.;
  return status;
}
}
