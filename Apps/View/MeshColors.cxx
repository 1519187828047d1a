// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshColors.h"

#include "MeshQuality.h"
#include "NearestTriangle.h"
#include "PolyDataConversion.h"
#include "SceneActors.h"

#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <utility>

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

/// How far `n` places are from a surface, in percent of a diagonal; none if it was stopped.
std::vector<float> distancesOf(std::size_t n, const std::function<Vec3(int)>& place,
  const NearestTriangle& surface, double diagonal, const std::function<bool()>& stopped)
{
  std::vector<float> distances(n);
  std::atomic<bool> stop{ false };
  vtkSMPTools::For(0, static_cast<vtkIdType>(n), 1024, [&](vtkIdType begin, vtkIdType end) {
    int hint = -1;
    stop = stop || stopped();
    for (vtkIdType i = begin; i < end && !stop; ++i)
    {
      const NearestTriangle::Hit hit = surface.find(place(static_cast<int>(i)), hint);
      hint = hit.face;
      distances[static_cast<std::size_t>(i)] =
        diagonal > 0 ? static_cast<float>(100 * std::sqrt(hit.squaredDistance) / diagonal) : 0;
    }
  });
  return stop ? std::vector<float>() : distances;
}

/// Of the points of `whole` that triangles use, and where these have edges longer than that of the
/// middles of edges and triangles: a point has the largest about it. None if it was stopped.
std::vector<float> missedOf(const TriangleSurface& whole, const NearestTriangle& made,
  double longEdge, double diagonal, const std::function<bool()>& stopped)
{
  std::vector<char> isUsed(whole.points.size(), 0);
  std::vector<Vec3> places;
  std::vector<Triangle> owners; // points that have the distance, some twice
  const auto add = [&](const Vec3& place, const Triangle& of) {
    places.push_back(place);
    owners.push_back(of);
  };
  for (const Face f : whole.faces())
  {
    const Triangle& t = whole.triangle(f);
    double longest = 0;
    for (int k = 0; k < 3; ++k)
    {
      const int p = t[k];
      if (isUsed[static_cast<std::size_t>(p)] == 0) // a file may have points that no triangle uses
      {
        isUsed[static_cast<std::size_t>(p)] = 1;
        add(whole.point(Vertex(p)), { { p, p, p } });
      }
      longest =
        std::max(longest, (whole.point(Vertex(p)) - whole.point(Vertex(t[(k + 1) % 3]))).norm());
    }
    if (longest > longEdge)
    {
      add(whole.position(f, Vec3::Constant(1. / 3)), t);
      for (int k = 0; k < 3; ++k)
      {
        const int a = t[k];
        const int b = t[(k + 1) % 3];
        add(0.5 * (whole.point(Vertex(a)) + whole.point(Vertex(b))), { { a, b, b } });
      }
    }
  }
  const std::vector<float> distances = distancesOf(
    places.size(), [&](int i) { return places[static_cast<std::size_t>(i)]; }, made, diagonal,
    stopped);
  std::vector<float> missed(distances.empty() ? 0 : whole.points.size(), 0);
  for (std::size_t i = 0; i < distances.size(); ++i)
  {
    for (const int p : owners[i])
    {
      float& most = missed[static_cast<std::size_t>(p)];
      most = std::max(most, distances[i]);
    }
  }
  return missed;
}

ColorScale distanceScale(const MeshColors& colors, const char* title)
{
  const double most = std::max(largestOf(colors.deviation), largestOf(colors.missed));
  return { 0, most,
    { divergingColor, { { 0, "0" }, { 0.5, printed(0.5 * most) }, { 1, printed(most) } }, title } };
}
}

MeshColors measureColors(
  vtkPolyData* mesh, const NearestTriangle& input, const std::function<bool()>& stopped)
{
  const TriangleSurface& whole = input.surface();
  const double diagonal = whole.boundingBoxDiagonal();
  std::vector<int> cell;
  const TriangleSurface surface = fromPolyData(mesh, &cell);
  const auto n = static_cast<std::size_t>(surface.numberOfFaces());
  // Their middles, and then those of their edges: corners are on the input, as a rule.
  constexpr std::size_t PlacesOfFace = 4;
  const std::vector<float> distances = distancesOf(
    PlacesOfFace * n,
    [&surface](int i) {
      const int place = i % static_cast<int>(PlacesOfFace);
      const Vec3 bary =
        place == 3 ? Vec3::Constant(1. / 3) : Vec3(0.5 * (Vec3::Ones() - Vec3::Unit(place)));
      return surface.position(Face(i / static_cast<int>(PlacesOfFace)), bary);
    },
    input, diagonal, stopped);
  MeshColors colors;
  if (!distances.empty())
  {
    colors.missed = missedOf(whole, NearestTriangle(surface), meanEdge(mesh), diagonal, stopped);
  }
  if (colors.missed.empty())
  {
    return {};
  }
  const auto cells = static_cast<std::size_t>(mesh->GetNumberOfCells());
  colors.quality.assign(cells, 1);
  colors.angle.assign(cells, 60);
  colors.deviation.assign(cells, 0);
  for (std::size_t f = 0; f < n; ++f)
  {
    const auto c = static_cast<std::size_t>(cell[f]);
    const TriangleShape shape = measureTriangle(surface, Face(static_cast<int>(f)));
    colors.quality[c] = std::min(colors.quality[c], static_cast<float>(shape.quality));
    colors.angle[c] = std::min(colors.angle[c], static_cast<float>(shape.smallestAngle));
    const auto first = distances.begin() + static_cast<std::ptrdiff_t>(PlacesOfFace * f);
    colors.deviation[c] =
      std::max(colors.deviation[c], *std::max_element(first, first + PlacesOfFace));
  }
  return colors;
}

std::vector<int> worstOf(const MeshColors& colors, MeshColoring coloring)
{
  const std::vector<float>& values =
    coloring == MeshColoring::Plain ? colors.angle : valuesOf(colors, coloring);
  const float sign = coloring == MeshColoring::Deviation ? -1.F : 1.F; // the least is the worst
  std::vector<int> order(values.size());
  std::iota(order.begin(), order.end(), 0);
  const auto worse = [&values, sign](int a, int b) {
    return std::pair(sign * values[static_cast<std::size_t>(a)], a) <
      std::pair(sign * values[static_cast<std::size_t>(b)], b);
  };
  const auto last = order.begin() + static_cast<std::ptrdiff_t>(std::min(order.size(), WorstOfAll));
  std::partial_sort(order.begin(), last, order.end(), worse);
  order.erase(last, order.end());
  return order;
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

vtkSmartPointer<vtkUnsignedCharArray> ColorScale::colorsOf(const std::vector<float>& values) const
{
  auto colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colors->SetName("Colors");
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    colors->SetTypedTuple(static_cast<vtkIdType>(i), this->pixelOf(values[i]).data());
  }
  return colors;
}

ColorScale scaleOf(const MeshColors& colors, MeshColoring coloring)
{
  // Good is blue: low deviations, and high angles and qualities.
  const auto turned = [](double share) { return divergingColor(1 - share); };
  if (coloring == MeshColoring::Deviation)
  {
    return distanceScale(colors, "distance from the input, % of its diagonal");
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

ColorScale missedScale(const MeshColors& colors)
{
  return distanceScale(colors, "distance from the mesh, % of the diagonal");
}

double largestOf(const std::vector<float>& distances)
{
  return distances.empty() ? 0 : *std::max_element(distances.begin(), distances.end());
}
}
