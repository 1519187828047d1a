// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Discrete conformal map of a disk chart to a rectangle (paper 2.2).
#ifndef stipple_ConformalMap_h
#define stipple_ConformalMap_h

#include "ChartMesh.h"
#include "ReportingThread.h"

namespace stipple
{
/// Share of an area that is too small to matter: what is denser in a map is not counted.
constexpr double NegligibleArea = 1e-3;

struct ConformalMapOptions
{
  bool square = false; ///< map to the unit square, not to the rectangle that suits the chart best
};

struct ConformalMap
{
  std::vector<Vec2> uv;       ///< by chart vertex, inside [0, extent]
  Vec2 extent = Vec2::Ones(); ///< the larger side is 1
  bool valid = false;         ///< every triangle has positive area in the plane
  bool fallback = false;      ///< the cotangent map had flips; positive weights were used instead
  /// 99.9 % of the area, and every triangle that has an angle in the plane by rounding only, have a
  /// density up to this multiple of the mean.
  double densityRatio = 0;
  std::vector<double> area;    ///< by chart triangle, on the surface
  std::vector<double> density; ///< by chart triangle, A3D / A2D over the chart's mean
};

/// Maps the chart's boundary to the rectangle by arc length and its interior by the cotangent
/// Laplacian (Eck et al. 1995; Pinkall and Polthier 1993). Where that flips a triangle, cotangents
/// are clamped to positive values, for which the map is one-to-one (Tutte 1963; Floater 2003); in a
/// long chart, the intrinsic Delaunay triangulation is tried before. The boundary needs four
/// vertices or more. A map that is stopped is not valid.
STIPPLEFILTERSATLAS_EXPORT ConformalMap mapToRectangle(const TriangleSurface& surface,
  const ChartMesh& chart, const ConformalMapOptions& options, const Stop& stop = {});

/// Maps the chart to the unit square with equal weights (W. T. Tutte, How to Draw a Graph, 1963):
/// valid whatever the triangles are like, and not conformal. The weights of needles may be so far
/// apart that the other map has triangles with an area by rounding only.
STIPPLEFILTERSATLAS_EXPORT ConformalMap mapByMeans(
  const TriangleSurface& surface, const ChartMesh& chart, const Stop& stop = {});

/// The density that no more than a share of the chart's area exceeds, over the mean.
STIPPLEFILTERSATLAS_EXPORT double densityQuantile(const ConformalMap& map, double share);

/// Measures the map anew: valid, area, density and densityRatio from uv.
STIPPLEFILTERSATLAS_EXPORT void measureMap(
  const TriangleSurface& surface, const ChartMesh& chart, ConformalMap& map);
}

#endif
