// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What a run found and did, as JSON.
#ifndef stipple_Report_h
#define stipple_Report_h

#include "MeshQuality.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stipple
{
struct Report
{
  std::string input;
  std::string output;
  long long inputPoints = 0;
  long long inputFaces = 0;
  int charts = 0;
  std::string mapBackend;
  std::vector<std::pair<std::string, double>> seconds; ///< by stage, in order
  std::vector<std::pair<std::string, long long>> repairs;
  int overlaps = 0; ///< pairs of triangles that pass through each other where the input does not
  std::optional<double> medianEdgeLength; ///< if one was asked for
  std::optional<double> deviation; ///< that was verified, % of the diagonal; if one was asked for
  MeshQuality quality;   ///< of the output; points, triangles and topology are told from it
  MeshDistance distance; ///< to the input, as repaired
};

[[nodiscard]] std::string toJson(const Report& report);
}

#endif
