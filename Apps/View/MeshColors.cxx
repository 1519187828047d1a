// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshColors.h"

#include "MeshQuality.h"
#include "NearestTriangle.h"
#include "PolyDataConversion.h"

#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace stipple
{
namespace
{
std::string printed(double value)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.2g", value);
  return text;
}
}

MeshColors measureColors(vtkPolyData* mesh, const NearestTriangle& input, double diagonal,
  const std::function<bool()>& stopped)
{
  std::vector<int> cell;
  const TriangleSurface surface = fromPolyData(mesh, &cell);
  const auto n = static_cast<std::size_t>(surface.numberOfFaces());
  std::vector<TriangleShape> shapes(n);
  std::vector<double> distances(n);
  std::atomic<bool> stop{ false };
  vtkSMPTools::For(0, static_cast<vtkIdType>(n), 1024, [&](vtkIdType begin, vtkIdType end) {
    int hint = -1;
    stop = stop || stopped();
    for (vtkIdType i = begin; i < end && !stop; ++i)
    {
      const auto f = static_cast<std::size_t>(i);
      const Face face(static_cast<int>(i));
      const NearestTriangle::Hit hit =
        input.find(surface.position(face, Vec3::Constant(1. / 3)), hint);
      hint = hit.face;
      shapes[f] = measureTriangle(surface, face);
      distances[f] = diagonal > 0 ? 100 * std::sqrt(hit.squaredDistance) / diagonal : 0;
    }
  });
  if (stop)
  {
    return {};
  }
  MeshColors colors;
  const auto cells = static_cast<std::size_t>(mesh->GetNumberOfCells());
  colors.quality.assign(cells, 1);
  colors.angle.assign(cells, 60);
  colors.deviation.assign(cells, 0);
  for (std::size_t f = 0; f < n; ++f)
  {
    const auto c = static_cast<std::size_t>(cell[f]);
    colors.quality[c] = std::min(colors.quality[c], static_cast<float>(shapes[f].quality));
    colors.angle[c] = std::min(colors.angle[c], static_cast<float>(shapes[f].smallestAngle));
    colors.deviation[c] = std::max(colors.deviation[c], static_cast<float>(distances[f]));
  }
  std::vector<int> order(cells);
  std::iota(order.begin(), order.end(), 0);
  const auto worse = [&colors](int a, int b) {
    return std::pair(colors.angle[static_cast<std::size_t>(a)], a) <
      std::pair(colors.angle[static_cast<std::size_t>(b)], b);
  };
  const auto last = order.begin() + static_cast<std::ptrdiff_t>(std::min(cells, WorstOfAll));
  std::partial_sort(order.begin(), last, order.end(), worse);
  colors.worst.assign(order.begin(), last);
  return colors;
}

const std::vector<float>& valuesOf(const MeshColors& colors, MeshColoring coloring)
{
  static const std::vector<float> none;
  return coloring == MeshColoring::Quality ? colors.quality
    : coloring == MeshColoring::Angle      ? colors.angle
    : coloring == MeshColoring::Deviation  ? colors.deviation
                                           : none;
}

Pixel ColorScale::pixelOf(double value) const
{
  return this->bar.color(
    this->high > this->low ? (value - this->low) / (this->high - this->low) : 0);
}

ColorScale scaleOf(const MeshColors& colors, MeshColoring coloring)
{
  // Good is blue: low deviations, and high angles and qualities.
  const auto turned = [](double share) { return divergingColor(1 - share); };
  if (coloring == MeshColoring::Deviation)
  {
    const double most = colors.deviation.empty()
      ? 0
      : *std::max_element(colors.deviation.begin(), colors.deviation.end());
    return { 0, most,
      { divergingColor, { { 0, "0" }, { 0.5, printed(0.5 * most) }, { 1, printed(most) } },
        "distance from the input, % of its diagonal" } };
  }
  if (coloring == MeshColoring::Angle)
  {
    return { 0, 60,
      { turned, { { 0, "0\u00b0" }, { 0.25, "15\u00b0" }, { 0.5, "30\u00b0" }, { 1, "60\u00b0" } },
        "smallest angle" } };
  }
  return { 0, 1,
    { turned, { { 0, "0" }, { 0.5, "0.5" }, { 1, "1" } }, "quality; 1: equilateral" } };
}
}
