// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Numbers in text, independent of the locale: on the command line, and in small files of the
// user's.
#ifndef stipple_TextNumbers_h
#define stipple_TextNumbers_h

#include "Geometry.h"
#include "Progress.h"

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stipple
{
/// The whole text is one finite number.
[[nodiscard]] bool parseNumber(const std::string& text, double& value);

/// The whole text is one number, infinite ones and "nan" among them: the files of others have them.
[[nodiscard]] bool parseAnyNumber(std::string_view text, double& value);

/// The whole text is one whole number within the range.
[[nodiscard]] bool parseInteger(const std::string& text, long long low, long long high, int& value);

/// "0:1,0.5:0.2,1:1" → pairs; what is wrong with it, or nothing.
[[nodiscard]] std::string parseTransfer(
  const std::string& text, std::vector<std::pair<double, double>>& points);

/// The shortest text that reads back as the same double.
[[nodiscard]] std::string shortestText(double value);

/// Positions, x y z a line; empty lines and what follows # are skipped. Errors name file and line.
[[nodiscard]] Status readPositions(const std::string& file, std::vector<Vec3>& positions);

/// Strokes of the brush, x y z radius strength a line, the radius positive and the strength at
/// least -1; empty lines and what follows # are skipped. Errors name file and line.
[[nodiscard]] Status readStrokes(
  const std::string& file, std::vector<std::array<double, 5>>& strokes);

/// Pairs of point ids below numberOfPoints, two a line. Errors name file and line.
[[nodiscard]] Status readEdges(
  const std::string& file, long long numberOfPoints, std::vector<std::array<long long, 2>>& edges);
}

#endif
