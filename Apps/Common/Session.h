// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Everything that a user decides about a remesh, as one plain value: what undo goes back to, what a
// session file holds, what both programs hand to the filters.
#ifndef stipple_Session_h
#define stipple_Session_h

#include "Geometry.h"

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace stipple
{
struct Session
{
  std::string model; ///< file of the input surface; empty: not said

  // Sampling
  int points = 0;                        ///< exact number of points; 0: as many as the input has
  std::string importance = "uniform";    ///< one of importanceNames()
  std::string importanceArray;           ///< for the importance "array": its name
  std::string importanceImage;           ///< for the importance "image": its file
  std::string imageProjection = "chart"; ///< one of imageProjectionNames()
  std::array<double, 2> bandPass = { { 0, 0 } };   ///< fine, coarse, percent of the diagonal; none
  double gamma = 1.;                               ///< power of the importance, 0 to 100
  std::vector<std::pair<double, double>> transfer; ///< ascending in x, both in [0, 1]; empty: none
  double gradation = 0.;       ///< low-pass of the importance, percent of the diagonal, 0 to 100
  double minimumDensity = .02; ///< least importance, fraction of the largest, 0 to 1
  std::vector<std::array<double, 5>> strokes; ///< of the brush: x, y, z, radius, strength

  // Features and charts
  double featureAngle = 40.;                          ///< degrees, 0 to 180
  int charts = 1;                                     ///< at least so many, 1 to 100000
  std::vector<std::array<long long, 2>> featureEdges; ///< the input's point ids
  std::vector<Vec3> constraints;                      ///< positions that must become vertices

  bool operator==(const Session& o) const;
  bool operator!=(const Session& o) const { return !(*this == o); }
};

/// "uniform", "mean", ...; the index of each is its vtkControlMap::ImportanceType.
[[nodiscard]] const std::vector<std::string>& importanceNames();
/// "chart", "x", "y", "z"; the index of each is its vtkControlMap::ProjectionType.
[[nodiscard]] const std::vector<std::string>& imageProjectionNames();
}

#endif
