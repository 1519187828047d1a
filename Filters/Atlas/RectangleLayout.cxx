// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RectangleLayout.h"

#include "AtlasConstants.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace stipple
{
using Constants = AtlasConstants;

RectangleLayout::RectangleLayout(const TriangleSurface& surface, const ChartMesh& chart)
  : Chart(chart)
{
  const std::size_t n = chart.boundary.size();
  this->ArcLength.assign(n + 1, 0.);
  for (std::size_t i = 0; i < n; ++i)
  {
    const Vec3& a = surface.points[chart.vertices[chart.boundary[i]]];
    const Vec3& b = surface.points[chart.vertices[chart.boundary[(i + 1) % n]]];
    this->ArcLength[i + 1] = this->ArcLength[i] + (b - a).norm();
    this->Outline.push_back(a);
  }
  this->Area = std::accumulate(chart.faces.begin(), chart.faces.end(), 0.,
    [&](double sum, Face f) { return sum + surface.faceArea(f); });
  std::vector<double> turn(chart.vertices.size(), Pi);
  for (const Triangle& t : chart.triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (chart.onBoundary[t[k]])
      {
        const Vec3& p = surface.points[chart.vertices[t[k]]];
        const Vec3 u = surface.points[chart.vertices[t[nextCorner(k)]]] - p;
        const Vec3 v = surface.points[chart.vertices[t[previousCorner(k)]]] - p;
        turn[t[k]] -= std::atan2(u.cross(v).norm(), u.dot(v));
      }
    }
  }
  for (int v : chart.boundary)
  {
    this->Turn.push_back(turn[v]);
  }
}

std::vector<RectangleLayout::Corner> RectangleLayout::sharpestCorners() const
{
  const int n = static_cast<int>(this->Turn.size());
  const double total = this->ArcLength.back();
  const auto at = [&](int i) { return this->ArcLength[i] / total; };
  const auto distance = [](double s, double t) {
    const double d = std::abs(s - t);
    return std::min(d, 1 - d);
  };
  std::vector<Corner> candidates;
  for (int i = 0; i < n; ++i)
  {
    double turn = this->Turn[i];
    for (int step : { 1, n - 1 })
    {
      for (int j = (i + step) % n; j != i && distance(at(i), at(j)) <= Constants::CornerWindow;
           j = (j + step) % n)
      {
        turn += this->Turn[j];
      }
    }
    // Of the vertices of one corner, the one that turns most itself.
    candidates.push_back({ at(i), turn + 1e-3 * this->Turn[i] });
  }
  std::stable_sort(candidates.begin(), candidates.end(),
    [](const Corner& a, const Corner& b) { return a.turn > b.turn; });
  std::vector<Corner> corners;
  for (const Corner& c : candidates)
  {
    if (c.turn < Constants::LeastTurn || corners.size() == Constants::MostCorners)
    {
      break;
    }
    if (std::all_of(corners.begin(), corners.end(), [&](const Corner& other) {
          return distance(c.at, other.at) >= Constants::BetweenCorners;
        }))
    {
      corners.push_back(c);
    }
  }
  return corners;
}

std::vector<RectangleLayout::Corner> RectangleLayout::cornersOfSlender() const
{
  std::vector<Corner> corners;
  for (std::size_t i = 0; i < this->Turn.size(); ++i)
  {
    if (this->Turn[i] >= Constants::LeastTurnOfSlender)
    {
      corners.push_back({ this->ArcLength[i] / this->ArcLength.back(), this->Turn[i] });
    }
  }
  return corners.size() == 4 ? corners : std::vector<Corner>();
}

Vec3 RectangleLayout::pointAt(double fraction) const
{
  const double s = (fraction - std::floor(fraction)) * this->ArcLength.back();
  const auto next = std::upper_bound(this->ArcLength.begin(), this->ArcLength.end() - 1, s);
  const auto i = static_cast<std::size_t>(next - this->ArcLength.begin()) - 1;
  const double length = this->ArcLength[i + 1] - this->ArcLength[i];
  const double t = length > 0 ? (s - this->ArcLength[i]) / length : 0.;
  return (1 - t) * this->Outline[i] + t * this->Outline[(i + 1) % this->Outline.size()];
}

std::optional<double> RectangleLayout::foldOfLong(double length, double width) const
{
  const auto across = [&](double end, int i) {
    const double t = 0.5 * (i + 0.5) / Constants::PlacesOnFold;
    return (this->pointAt(end + t) - this->pointAt(end - t)).norm();
  };
  const auto misfit = [&](double end) {
    double sum = 0;
    for (int i = 0; i < Constants::PlacesOnFold; ++i)
    {
      sum += across(end, i);
    }
    return sum;
  };
  // All around, then between the neighbours of the best, closer and closer.
  const double precision = 0.125 * width / this->ArcLength.back();
  double best = 0;
  double least = std::numeric_limits<double>::infinity();
  double from = 0;
  double step = 0.5 / Constants::PlacesOnFold;
  for (int tried = Constants::PlacesOnFold; step > 0.25 * precision; tried = 9)
  {
    for (int i = 0; i < tried; ++i)
    {
      const double end = from + i * step;
      const double here = misfit(end);
      if (here < least)
      {
        least = here;
        best = end;
      }
    }
    from = best - step;
    step *= 0.25;
  }
  for (int i = 0; i < Constants::PlacesOnFold; ++i)
  {
    if (across(best, i) * Constants::LongChart > length)
    {
      return {};
    }
  }
  return best;
}

std::vector<RectanglePlacement> RectangleLayout::placementsOfLong() const
{
  const double perimeter = this->ArcLength.back();
  const double quarter = 0.25 * perimeter;
  const double length = quarter + std::sqrt(std::max(0., quarter * quarter - this->Area)); // of a x
                                                                                           // b, a
                                                                                           // >= b
  const double width = length > 0 ? this->Area / length : 0.;
  if (!(length > Constants::LongChart * width) || !(width > 0))
  {
    return {};
  }
  const std::optional<double> fold = this->foldOfLong(length, width);
  if (!fold)
  {
    return {};
  }
  const double end = *fold;
  const double half = 0.5 * width / perimeter;
  RectanglePlacement placement;
  placement.corner = { end + half, end + 0.5 - half, end + 0.5 + half, end + 1 - half };
  placement.extent = Vec2(1, 1);
  placement.fits = true;
  std::vector<RectanglePlacement> placements = { placement };
  // Each corner to the sharpest within the chart's width.
  for (double& corner : placement.corner)
  {
    double most = Constants::LeastTurn;
    const double asPlaced = corner;
    for (std::size_t i = 0; i < this->Turn.size(); ++i)
    {
      const double at = this->ArcLength[i] / perimeter;
      const double apart = at - asPlaced - std::round(at - asPlaced);
      if (std::abs(apart) <= 2 * half && this->Turn[i] > most)
      {
        most = this->Turn[i];
        corner = asPlaced + apart;
      }
    }
  }
  placements.push_back(placement);
  return placements;
}

std::vector<RectanglePlacement> RectangleLayout::placements(bool square) const
{
  std::vector<Corner> corners = this->sharpestCorners();
  const double start = corners.empty() ? 0. : corners.front().at;
  std::vector<RectanglePlacement> placements;
  const auto addTurned = [&](double aspect, double turn) {
    const double wide = 0.5 * aspect / (1 + aspect);
    const double s = start + turn;
    placements.push_back({ { s, s + wide, s + 0.5, s + 0.5 + wide }, Vec2(1, 1 / aspect) });
  };
  addTurned(1, 0);
  addTurned(1, 1. / 8);
  if (!square)
  {
    for (double aspect : { 2., 4. })
    {
      for (int turn = 0; turn < 4; ++turn)
      {
        addTurned(aspect, turn / 8.);
      }
    }
  }
  const std::vector<RectanglePlacement> ofLong =
    square ? std::vector<RectanglePlacement>() : this->placementsOfLong();
  const bool isLong = !ofLong.empty();
  placements.insert(placements.end(), ofLong.begin(), ofLong.end());
  if (corners.size() < 4)
  {
    corners = this->cornersOfSlender();
  }
  // Four of the sharpest corners, the sharpest first.
  struct Choice
  {
    double turn;
    std::array<double, 4> at;
  };
  std::vector<Choice> choices;
  const std::size_t n = corners.size();
  for (unsigned mask = 0; mask < (1U << n); ++mask)
  {
    Choice choice = { 0, {} };
    std::size_t count = 0;
    for (std::size_t i = 0; i < n; ++i)
    {
      if (mask >> i & 1U)
      {
        choice.at[std::min<std::size_t>(count++, 3)] = corners[i].at;
        choice.turn += corners[i].turn;
      }
    }
    if (count == 4)
    {
      std::sort(choice.at.begin(), choice.at.end());
      choices.push_back(choice);
    }
  }
  std::stable_sort(choices.begin(), choices.end(),
    [](const Choice& a, const Choice& b) { return a.turn > b.turn; });
  choices.resize(std::min(choices.size(), Constants::MostChoices));
  for (const Choice& c : choices)
  {
    const double width = (c.at[1] - c.at[0]) + (c.at[3] - c.at[2]);
    const double height = (c.at[2] - c.at[1]) + (1 + c.at[0] - c.at[3]);
    const double aspect = square
      ? 1.
      : std::clamp(width / height, 1 / Constants::LongRectangle, Constants::LongRectangle);
    placements.push_back({ c.at, aspect > 1 ? Vec2(1, 1 / aspect) : Vec2(aspect, 1), isLong });
  }
  return placements;
}

void RectangleLayout::place(const RectanglePlacement& placement, std::vector<Vec2>& uv) const
{
  const int n = static_cast<int>(this->Chart.boundary.size());
  if (n < 3) // two charts may have all of their borders but two edges in common, and be tried as
             // one
  {
    for (const int v : this->Chart.boundary)
    {
      uv[v] = Vec2::Zero();
    }
    return;
  }
  const double total = this->ArcLength[n];
  std::array<int, 4> corner;
  for (int k = 0; k < 4; ++k)
  {
    const double s = (placement.corner[k] - std::floor(placement.corner[k])) * total;
    const auto next = std::lower_bound(this->ArcLength.begin(), this->ArcLength.end() - 1, s);
    int i = static_cast<int>(next - this->ArcLength.begin());
    if (i > 0 && s - this->ArcLength[i - 1] < this->ArcLength[i] - s)
    {
      --i;
    }
    corner[k] = i % n;
  }
  // Corners in cyclic order and on different vertices, whatever the boundary's spacing; but that
  // three vertices have the first two of them at one.
  for (int k = 1; k < 4; ++k)
  {
    const int from = (corner[k] - corner[0] + n) % n;
    const int least = (corner[k - 1] - corner[0] + n) % n + 1;
    corner[k] = (corner[0] + std::min(std::max(from, least), n - 4 + k)) % n;
  }
  const Vec2& e = placement.extent;
  const std::array<Vec2, 5> at = { Vec2(0, 0), Vec2(e.x(), 0), e, Vec2(0, e.y()), Vec2(0, 0) };
  for (int k = 0; k < 4; ++k)
  {
    const int begin = corner[k];
    const int count = (corner[(k + 1) % 4] - begin + n) % n;
    const auto lengthTo = [&](int j) {
      const int i = begin + j;
      return i <= n ? this->ArcLength[i] - this->ArcLength[begin]
                    : total - this->ArcLength[begin] + this->ArcLength[i - n];
    };
    const double side = lengthTo(count);
    for (int j = 0; j < count; ++j)
    {
      const double t = side > 0 ? lengthTo(j) / side : static_cast<double>(j) / count;
      // Exactly on the side: the coordinate that is constant is copied, not computed.
      Vec2 p = at[k] + t * (at[k + 1] - at[k]);
      p[k % 2 == 0 ? 1 : 0] = at[k][k % 2 == 0 ? 1 : 0];
      uv[this->Chart.boundary[(begin + j) % n]] = p;
    }
  }
}
}
