// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "EdgeLengthSearch.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace stipple
{
namespace
{
constexpr int MostLengths = 5;
/// Of the logarithm of lengths over that of numbers; on a smooth surface it is a half.
constexpr double GentlestSlope = 0.25;
constexpr double SteepestSlope = 1.;
}

double medianEdgeLength(const TriangleSurface& mesh)
{
  std::vector<double> lengths;
  for (const Halfedge h : mesh.halfedges())
  {
    if (mesh.twin[h] < h) // or has none
    {
      lengths.push_back(mesh.edgeLength(h));
    }
  }
  if (lengths.empty())
  {
    return 0.;
  }
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

EdgeLengthSearch::EdgeLengthSearch(double wanted)
  : Wanted(wanted)
{
}

void EdgeLengthSearch::add(int asked, int got, double median)
{
  ++this->Trials;
  const Trial before = this->Last;
  this->Last = { got, std::log(median / this->Wanted) };
  if (this->Best.points == 0 || std::abs(this->Last.error) < std::abs(this->Best.error))
  {
    this->Best = this->Last;
  }
  double slope = 0.5;
  if (before.points > 0 && before.points != got)
  {
    slope = (this->Last.error - before.error) /
      std::log(static_cast<double>(before.points) / static_cast<double>(got));
  }
  const double points =
    got * std::exp(this->Last.error / std::clamp(slope, GentlestSlope, SteepestSlope));
  const bool isNear = std::abs(std::expm1(this->Last.error)) <= Tolerance;
  const bool isLeast = got > asked && points < got;
  this->Next = isNear || isLeast || this->Trials == MostLengths
    ? 0
    : std::max(1, static_cast<int>(std::lround(points)));
}
}
