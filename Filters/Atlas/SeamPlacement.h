// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Smooth seams between charts (paper 2.5): straight lines of a conformal plane.
#ifndef stipple_SeamPlacement_h
#define stipple_SeamPlacement_h

#include "ChartRegions.h"
#include "Progress.h"

#include <optional>

namespace stipple
{
/// Where the seam between two charts runs.
enum class BoundaryPlacement
{
  AreaMedian, ///< along the isoline that halves the area
  Middle,     ///< along the isoline halfway across the plane (slips away from curved parts)
  Voronoi     ///< along the edges between Voronoi regions, not smoothed
};

struct SeamPlacement
{
  /// Which isoline of the conformal map becomes the seam: the one that has this fraction of the
  /// area on the first region's side; without one, the isoline halfway.
  std::optional<double> areaFraction = 0.5;
  /// Cut triangles along the isoline, else move the seam to the edges next to it.
  bool exact = true;
  /// With a fraction: share of the area on either side, the farthest from the seam, that stays out
  /// of the map. Lines near the middle hardly change, and the system is smaller.
  double leftOut = 0.5;
};

/// Moves a seam between two regions that are disks. Their union along the seam is mapped
/// conformally to a rectangle of two by one, each region's far side on a short side (a sphere's
/// union: to a cylinder between the points that are farthest from the seam), and the seam becomes a
/// line across. False, with the seam as it was, if that would not leave two disks.
STIPPLEFILTERSATLAS_EXPORT bool placeSeam(
  ChartRegions& regions, int a, int b, const SeamArc& arc, const SeamPlacement& placement);

/// Moves the seams between all regions: balanceAreas, if there are more than two, then cutSeams.
STIPPLEFILTERSATLAS_EXPORT Status placeSeams(
  ChartRegions& regions, BoundaryPlacement placement, const Progress& progress);

/// Moves the seams between all regions by whole triangles, pair by pair, until the regions' areas
/// are alike; for BoundaryPlacement::AreaMedian alone.
STIPPLEFILTERSATLAS_EXPORT Status balanceAreas(
  ChartRegions& regions, BoundaryPlacement placement, const Progress& progress);

/// Moves the seams between all regions to smooth lines, pair by pair; nothing for
/// BoundaryPlacement::Voronoi. areBalanced: areas are as they should be, and seams in their places
/// but for being jagged; areas stay, and seams are seen from nearby.
STIPPLEFILTERSATLAS_EXPORT Status cutSeams(
  ChartRegions& regions, BoundaryPlacement placement, bool areBalanced, const Progress& progress);

/// Smooths the seams between two regions and keeps their areas; nothing for
/// BoundaryPlacement::Voronoi.
STIPPLEFILTERSATLAS_EXPORT void smoothSeams(
  ChartRegions& regions, int a, int b, BoundaryPlacement placement);
}

#endif
