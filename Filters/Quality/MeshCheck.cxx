// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshCheck.h"

#include "MeshQuality.h"
#include "MessageText.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace stipple
{
namespace
{
// Edge lengths that mesh and surface may be apart: more is the middle of a gap of four, which has
// room for some twenty samples.
constexpr double LargestGap = 2.;

double longestEdge(const TriangleSurface& mesh, int face)
{
  double longest = 0;
  for (int k = 0; k < 3; ++k)
  {
    longest = std::max(longest, (mesh.point(face, k) - mesh.point(face, (k + 1) % 3)).norm());
  }
  return longest;
}

Status faultOf(const TriangleSurface& mesh, const SurfaceTopology& wanted)
{
  const auto fault = [](const std::string& what) {
    return Status::tooFewPoints("The mesh would have " + what + ": ask for more points.");
  };
  const MeshQuality q = measureQuality(mesh);
  const int torn = q.nonManifoldEdges + q.nonManifoldVertices + q.misorientedEdges;
  if (q.isolatedPoints > 0)
  {
    return fault(countOf(q.isolatedPoints, "point", "points") + " without a triangle");
  }
  if (torn > 0)
  {
    return fault(
      countOf(torn, "edge or point that is", "edges or points that are") + " not manifold");
  }
  const SurfaceTopology topology = mesh.topology();
  if (!(topology == wanted))
  {
    return fault("another topology than the surface (" + differenceOf(topology, wanted) + ")");
  }
  return q.degenerate == 0
    ? Status::success()
    : fault(countOf(q.degenerate, "triangle", "triangles") + " without an area");
}

/// Where mesh and surface are farthest apart, of the places that are too far from the other.
struct Gap
{
  double distance = 0;
  Vec3 place = Vec3::Zero();

  /// tooFar by triangle of the other. `nearest`: the places next to them, in the end.
  template <typename F>
  Status look(const std::vector<Vec3>& places, const TriangleSurface& other,
    const Progress& progress, const F& tooFar, std::vector<NearestTriangle::Hit>& nearest)
  {
    const Status status = nearestPlaces(places, other, progress, nearest);
    for (std::size_t i = 0; i < nearest.size() && status.ok(); ++i)
    {
      const double d = std::sqrt(nearest[i].squaredDistance);
      if (d > this->distance && d > tooFar(nearest[i].face))
      {
        this->distance = d;
        this->place = places[i];
      }
    }
    return status;
  }
};

/// Places of the surface, and what of the mesh is next to them.
struct SurfaceSamples
{
  std::vector<Vec3> places;
  std::vector<NearestTriangle::Hit> nearest;
};

/// Centroids of the triangles that may leave the surface by more than so much: no place of a
/// triangle is farther from its nearest corner, which lies on the surface, than its longest edge
/// over the root of 3, and a place of the surface that is next to it may be near enough as well.
std::vector<Vec3> centroidsOfLong(
  const TriangleSurface& mesh, const SurfaceSamples& samples, double tooFar)
{
  std::vector<char> mayLeave(static_cast<std::size_t>(mesh.numberOfFaces()));
  for (int f = 0; f < mesh.numberOfFaces(); ++f)
  {
    mayLeave[f] = longestEdge(mesh, f) > std::sqrt(3.) * tooFar ? 1 : 0;
  }
  const auto centroid = [&](int f) { return mesh.position(f, Vec3::Constant(1. / 3.)); };
  for (std::size_t i = 0; i < samples.nearest.size(); ++i)
  {
    const int f = samples.nearest[i].face;
    if (mayLeave[f] != 0 && (samples.places[i] - centroid(f)).norm() <= tooFar)
    {
      mayLeave[f] = 0;
    }
  }
  std::vector<Vec3> centroids;
  for (int f = 0; f < mesh.numberOfFaces(); ++f)
  {
    if (mayLeave[f] != 0)
    {
      centroids.push_back(centroid(f));
    }
  }
  return centroids;
}
}

Status checkMesh(const TriangleSurface& mesh, const TriangleSurface& surface,
  const SurfaceTopology& topology, const Progress& progress)
{
  Status status = faultOf(mesh, topology);
  if (!status.ok() || mesh.numberOfFaces() == 0) // as many as the surface has
  {
    return status;
  }
  const double edge = std::sqrt(4. / std::sqrt(3.) * surface.area() / mesh.numberOfFaces());
  const double tooFar = LargestGap * edge;
  Gap gap;
  SurfaceSamples samples;
  samples.places = sampleSurface(surface, static_cast<int>(mesh.points.size()));
  status = gap.look(
    samples.places, mesh, progress,
    [&](int face) { return std::max(tooFar, LargestGap * longestEdge(mesh, face)); },
    samples.nearest);
  if (!status.ok())
  {
    return status;
  }
  const std::vector<Vec3> centroids = centroidsOfLong(mesh, samples, tooFar);
  if (!centroids.empty()) // else the surface needs no locator
  {
    status = gap.look(
      centroids, surface, progress, [&](int) { return tooFar; }, samples.nearest);
  }
  if (!status.ok() || gap.distance == 0)
  {
    return status;
  }
  std::ostringstream sentence;
  sentence << "Mesh and surface would be " << gap.distance << " apart at (" << gap.place.x() << ", "
           << gap.place.y() << ", " << gap.place.z()
           << "), over twice the length of edges there: ask for more points.";
  return Status::tooFewPoints(sentence.str());
}
}
