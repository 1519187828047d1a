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
/// A point of the surface, and the nearest triangle of the mesh.
struct FarPlace
{
  int point;
  Face face;
  double distance;
};

/// Points of the surface, on no crease, that are farther from the mesh than a share of the spacing
/// there; the farthest first.
STIPPLEFILTERSOPTIMIZATION_EXPORT Status farPlaces(
  const OptimizedMesh& mesh, double share, const Progress& progress, std::vector<FarPlace>& places);

/// Puts vertices that are needed less elsewhere at far places, where they stay, if the triangles
/// about them are good enough for what it brings: the farther away, the less so. What a distance is
/// worth is the exchange rate of simplifyFeatures(): one as long as `tolerance` spacings a triangle
/// without an angle, less one with more of it.
STIPPLEFILTERSOPTIMIZATION_EXPORT Status reachPlaces(
  OptimizedMesh& mesh, const std::vector<FarPlace>& places, double tolerance);
}

#endif
