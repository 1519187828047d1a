// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFaults.h"

#include "Tuning.h"
#include "VertexStar.h"

#include <algorithm>
#include <cmath>

namespace stipple
{
namespace
{
bool isBetweenCreases(const OptimizedMesh& mesh, Face f)
{
  // The smallest angle is across from the shortest edge.
  const auto length = [&](Halfedge h) {
    return (mesh.position(mesh.to(h)) - mesh.position(mesh.from(h))).norm();
  };
  const TriangleCorners corners = mesh.triangleCorners(f);
  const Halfedge shortest = *std::min_element(
    corners.begin(), corners.end(), [&](Halfedge h, Halfedge g) { return length(h) < length(g); });
  return mesh.isCrease(mesh.edge(mesh.next(shortest))) &&
    mesh.isCrease(mesh.edge(mesh.previous(shortest)));
}

FaultSum operator+(const FaultSum& a, const FaultSum& b)
{
  return { a.overlaps + b.overlaps, a.lack + b.lack };
}
}

bool FaultSum::isMuchLessThan(const FaultSum& o) const
{
  constexpr double Share = 1. - Tuning::LeastGainOfRefinement;
  return o.overlaps > 0 ? this->overlaps <= Share * o.overlaps : this->lack <= Share * o.lack;
}

MeshFaults::MeshFaults(const OptimizedMesh& mesh, KnownOverlaps& known)
{
  const std::vector<Face> overlaps =
    known.left == 0 ? std::vector<Face>() : overlapsOf(mesh, SelfIntersections(mesh), known);
  for (const Face f : mesh.faces())
  {
    FaultSum share;
    share.overlaps = std::binary_search(overlaps.begin(), overlaps.end(), f) ? 1 : 0;
    const double angle = faceQuality(mesh, f);
    if (angle < Tuning::NarrowAngle && !isBetweenCreases(mesh, f))
    {
      share.lack = std::pow(Tuning::NarrowAngle - angle, 2);
    }
    if (FaultSum() < share)
    {
      const auto [a, b, c] = mesh.corners(f);
      this->Faults.push_back(
        { f, (mesh.position(a) + mesh.position(b) + mesh.position(c)) / 3., share });
    }
  }
}

FaultSum MeshFaults::sum() const
{
  FaultSum sum;
  for (const Fault& fault : this->Faults)
  {
    sum = sum + fault.share;
  }
  return sum;
}

FaultSum MeshFaults::sumNear(const Vec3& place, double distance) const
{
  FaultSum sum;
  for (const Fault& fault : this->Faults)
  {
    sum = (fault.position - place).norm() < distance ? sum + fault.share : sum;
  }
  return sum;
}
}
