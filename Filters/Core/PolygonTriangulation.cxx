// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PolygonTriangulation.h"

#include <algorithm>
#include <numeric>

namespace stipple
{
namespace
{
/// Cuts off ears of a polygon in the plane, counterclockwise, the best shaped first.
class EarCutting
{
public:
  explicit EarCutting(std::vector<Vec2> corners)
    : Corners(std::move(corners))
    , Rest(this->Corners.size())
  {
    std::iota(this->Rest.begin(), this->Rest.end(), 0);
  }

  std::vector<Triangle> run()
  {
    std::vector<Triangle> triangles;
    this->rateAll();
    while (this->Rest.size() > 3)
    {
      std::size_t best = this->best();
      if (!(this->Ratings[best] > 0))
      {
        this->rateAll(); // a corner that was in the way may be gone
        best = this->best();
      }
      triangles.push_back(this->ear(best));
      this->Rest.erase(this->Rest.begin() + static_cast<std::ptrdiff_t>(best));
      this->Ratings.erase(this->Ratings.begin() + static_cast<std::ptrdiff_t>(best));
      const std::size_t after = best % this->Rest.size();
      const std::size_t before = (best + this->Rest.size() - 1) % this->Rest.size();
      this->Ratings[after] = this->rate(after);
      this->Ratings[before] = this->rate(before);
    }
    triangles.push_back({ this->Rest[0], this->Rest[1], this->Rest[2] });
    return triangles;
  }

private:
  Triangle ear(std::size_t i) const
  {
    const std::size_t n = this->Rest.size();
    return { this->Rest[(i + n - 1) % n], this->Rest[i], this->Rest[(i + 1) % n] };
  }

  std::size_t best() const
  {
    return std::max_element(this->Ratings.begin(), this->Ratings.end()) - this->Ratings.begin();
  }

  void rateAll()
  {
    this->Ratings.resize(this->Rest.size());
    for (std::size_t i = 0; i < this->Rest.size(); ++i)
    {
      this->Ratings[i] = this->rate(i);
    }
  }

  /// Area over the sum of squared sides, 0 or less for what is no ear; -1 if another corner is in
  /// it.
  double rate(std::size_t i) const
  {
    const Triangle t = this->ear(i);
    const Vec2& a = this->Corners[t[0]];
    const Vec2& b = this->Corners[t[1]];
    const Vec2& c = this->Corners[t[2]];
    const double squares = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
    const double rating = squares > 0 ? orient2(a, b, c) / squares : 0.;
    if (!(rating > 0))
    {
      return rating < 0 ? rating - 1 : 0.;
    }
    const bool covers = std::any_of(this->Rest.begin(), this->Rest.end(), [&](int p) {
      const Vec2& x = this->Corners[p];
      return x != a && x != b && x != c && orient2(a, b, x) >= 0 && orient2(b, c, x) >= 0 &&
        orient2(c, a, x) >= 0;
    });
    return covers ? -1. : rating;
  }

  std::vector<Vec2> Corners;
  std::vector<int> Rest;
  std::vector<double> Ratings; // by place in the rest
};
}

std::vector<Triangle> triangulatePolygon(const std::vector<Vec3>& corners)
{
  const int n = static_cast<int>(corners.size());
  const auto fanFrom = [n](int first) {
    std::vector<Triangle> fan;
    for (int k = 2; k < n; ++k)
    {
      fan.push_back({ first, (first + k - 1) % n, (first + k) % n });
    }
    return fan;
  };
  const auto twiceAreaOf = [&corners](const Triangle& t) -> Vec3 {
    return (corners[t[1]] - corners[t[0]]).cross(corners[t[2]] - corners[t[0]]);
  };
  std::vector<Triangle> fan = fanFrom(0);
  Vec3 normal = Vec3::Zero();
  for (const Triangle& t : fan)
  {
    normal += twiceAreaOf(t);
  }
  const double length = normal.norm();
  const auto covers = [&](const std::vector<Triangle>& triangles) {
    return std::all_of(triangles.begin(), triangles.end(),
      [&](const Triangle& t) { return twiceAreaOf(t).dot(normal) > 0; });
  };
  // Which way a quad that is not plane is bent is up to its shorter diagonal, as vtkTriangleFilter
  // has it; where they are alike but for rounding to single precision, to its first corner.
  constexpr double Alike = 1 - 1e-6;
  if (n == 4 && (corners[1] - corners[3]).norm() < Alike * (corners[0] - corners[2]).norm())
  {
    if (std::vector<Triangle> other = fanFrom(1); covers(other))
    {
      return other;
    }
  }
  if (n <= 3 || covers(fan) || !(length > 0))
  {
    return fan;
  }
  const Vec3 x = (normal / length).unitOrthogonal();
  const Vec3 y = (normal / length).cross(x);
  std::vector<Vec2> plane;
  plane.reserve(corners.size());
  for (const Vec3& p : corners)
  {
    plane.emplace_back((p - corners[0]).dot(x), (p - corners[0]).dot(y));
  }
  return EarCutting(std::move(plane)).run();
}
}
