// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshCheck.h"

#include "MeshQuality.h"

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
  const auto some = [](int number, const char* one, const char* more) {
    return std::to_string(number) + " " + (number == 1 ? one : more);
  };
  const MeshQuality q = measureQuality(mesh);
  const int torn = q.nonManifoldEdges + q.nonManifoldVertices + q.misorientedEdges;
  if (q.isolatedPoints > 0)
  {
    return fault(some(q.isolatedPoints, "point", "points") + " without a triangle");
  }
  if (torn > 0)
  {
    return fault(some(torn, "edge or point that is", "edges or points that are") + " not manifold");
  }
  const SurfaceTopology topology = mesh.topology();
  if (!(topology == wanted))
  {
    return fault("another topology than the surface (Euler characteristic " +
      std::to_string(topology.euler) + " instead of " + std::to_string(wanted.euler) + ", " +
      std::to_string(topology.boundaryLoops) + " boundary loops instead of " +
      std::to_string(wanted.boundaryLoops) + ")");
  }
  return q.degenerate == 0
    ? Status::success()
    : fault(some(q.degenerate, "triangle", "triangles") + " without an area");
}

/// Where mesh and surface are farthest apart, of the places that are too far from the other.
struct Gap
{
  double distance = 0;
  Vec3 place = Vec3::Zero();

  /// tooFar by place.
  template <typename F>
  Status look(const std::vector<Vec3>& places, const TriangleSurface& other,
    const Progress& progress, const F& tooFar)
  {
    std::vector<NearestTriangle::Hit> nearest;
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

/// Centroids of the triangles that may leave the surface by more than so much: no place of a
/// triangle is farther from its nearest corner, which lies on the surface, than its longest edge
/// over the root of 3.
std::vector<Vec3> centroidsOfLong(const TriangleSurface& mesh, double tooFar)
{
  std::vector<Vec3> centroids;
  for (int f = 0; f < mesh.numberOfFaces(); ++f)
  {
    if (longestEdge(mesh, f) > std::sqrt(3.) * tooFar)
    {
      centroids.push_back(mesh.position(f, Vec3::Constant(1. / 3.)));
    }
  }
  return centroids;
}
}

Status checkMesh(const TriangleSurface& mesh, const TriangleSurface& surface,
  const SurfaceTopology& topology, const Progress& progress)
{
  Status status = faultOf(mesh, topology);
  if (!status.ok())
  {
    return status;
  }
  const double edge = std::sqrt(4. / std::sqrt(3.) * surface.area() / mesh.numberOfFaces());
  Gap gap;
  status = gap.look(sampleSurface(surface, static_cast<int>(mesh.points.size())), mesh, progress,
    [&](int face) { return LargestGap * std::max(edge, longestEdge(mesh, face)); });
  const std::vector<Vec3> centroids = centroidsOfLong(mesh, LargestGap * edge);
  if (status.ok() && !centroids.empty())
  {
    status = gap.look(centroids, surface, progress, [&](int) { return LargestGap * edge; });
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
