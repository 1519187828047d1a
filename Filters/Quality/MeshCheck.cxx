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
constexpr int PlacesForPoint = 3;

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
    return fault(std::to_string(q.isolatedPoints) + " points without a triangle");
  }
  if (torn > 0)
  {
    return fault(std::to_string(torn) + " edges or points that are not manifold");
  }
  const SurfaceTopology topology = mesh.topology();
  if (!(topology == wanted))
  {
    return fault("another topology than the surface (Euler characteristic " +
      std::to_string(topology.euler) + " instead of " + std::to_string(wanted.euler) + ", " +
      std::to_string(topology.boundaryLoops) + " boundary loops instead of " +
      std::to_string(wanted.boundaryLoops) + ")");
  }
  return q.degenerate == 0 ? Status::success()
                           : fault(std::to_string(q.degenerate) + " triangles without an area");
}
}

Status checkMesh(const TriangleSurface& mesh, const TriangleSurface& surface,
  const SurfaceTopology& topology, const Progress& progress)
{
  if (Status status = faultOf(mesh, topology); !status.ok())
  {
    return status;
  }
  const std::vector<Vec3> places =
    sampleSurface(surface, PlacesForPoint * static_cast<int>(mesh.points.size()));
  std::vector<NearestPlace> nearest;
  if (Status status = nearestPlaces(places, mesh, progress, nearest); !status.ok())
  {
    return status;
  }
  const double mean = std::sqrt(4. / std::sqrt(3.) * surface.area() / mesh.numberOfFaces());
  double most = 0;
  std::size_t farthest = places.size();
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const double distance = std::sqrt(nearest[i].squaredDistance);
    if (distance > most && distance > mean && distance > longestEdge(mesh, nearest[i].face))
    {
      most = distance;
      farthest = i;
    }
  }
  if (farthest == places.size())
  {
    return Status::success();
  }
  std::ostringstream sentence;
  sentence << "The surface at (" << places[farthest].x() << ", " << places[farthest].y() << ", "
           << places[farthest].z() << ") would be " << most
           << " away from the mesh, farther than triangles are long there: ask for more points.";
  return Status::tooFewPoints(sentence.str());
}
}
