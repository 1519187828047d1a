// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Vertices where the surface is far from the mesh: tips that are cut off, and pockets.
#ifndef stipple_FarPlaces_h
#define stipple_FarPlaces_h

#include "OptimizedMesh.h"
#include "Progress.h"
#include "StippleFiltersOptimizationModule.h"

namespace stipple
{
/// A place of the surface, and the nearest triangle of the mesh on the same component.
struct FarPlace
{
  SurfacePlace place;
  Vec3 position = Vec3::Zero();
  int backbone = -1; ///< that it lies on; none inside faces
  double arcLength = 0;
  Face face;
  double distance = 0;
};

/// Places of the surface that are farther from the mesh than a share of the spacing there, or than
/// what shows (VertexSpacing), the farthest first: of its points, and of others on creases and
/// inside large triangles, an edge of the mesh apart.
STIPPLEFILTERSOPTIMIZATION_EXPORT Status farPlaces(
  const OptimizedMesh& mesh, double share, const Progress& progress, std::vector<FarPlace>& places);

/// Puts vertices that are needed less elsewhere at far places, where they stay, if the triangles
/// about them are good enough for what it brings: the farther away, the less so. Those on a crease
/// that the mesh has go into its edge there. What a distance is
/// worth is the exchange rate of simplifyFeatures(): one as long as `tolerance` spacings a triangle
/// without an angle, less one with more of it.
STIPPLEFILTERSOPTIMIZATION_EXPORT Status reachPlaces(
  OptimizedMesh& mesh, const std::vector<FarPlace>& places, double tolerance);
}

#endif
