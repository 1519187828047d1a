// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Lengths of edges that a surface's curvature asks for.
#ifndef stipple_CurvatureSizes_h
#define stipple_CurvatureSizes_h

#include "AtlasSurface.h"
#include "ControlImage.h"
#include "ReportingThread.h"

#include <limits>
#include <vector>

namespace stipple
{
struct CurvatureSizeOptions
{
  /// So many edges make a full turn, above 0: where a normal curvature is k, their length is
  /// 2 pi / (points k), which turns by 2 pi / points.
  double pointsPerTurn = 0;
  double smallest = 0; ///< no edges are to be shorter, 0 or more
  double largest = std::numeric_limits<double>::infinity(); ///< or longer: of flat places
  /// Ratio of the lengths of neighbouring edges at most, above 1; 0: lengths may jump.
  double growth = 0;
};

/// The lengths at the pixels of the charts' images (with areaDistortion and faceIndex), by chart:
/// from the charts' cell array "LargestNormalCurvature". They do not grow if there would be more
/// samples than can be had. An error without that array; aborted if it was stopped.
STIPPLEFILTERSSAMPLING_EXPORT Status curvatureSizes(const AtlasSurface& surface,
  const std::vector<ControlImage>& images, const CurvatureSizeOptions& options,
  const Progress& progress, std::vector<std::vector<float>>& sizes);

/// The largest edges where nothing else bounds them: those of pointsPerTurn about the bounding box,
/// on a sphere of this diameter. (A closed surface within a sphere is somewhere bent as much.)
inline double largestOfTurn(double pointsPerTurn, double diagonal)
{
  return Pi * diagonal / pointsPerTurn;
}
}

#endif
