// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Curvature.h"

#include "AtlasConstants.h"

#include <cmath>

namespace stipple
{
using Constants = AtlasConstants;

Curvature computeCurvature(const TriangleSurface& surface, const Stop& stop)
{
  const std::size_t n = surface.points.size();
  Curvature result;
  result.mixedArea.assign(n, 0.);
  result.gaussian.assign(n, 2 * Pi);
  result.mean.assign(n, 0.);
  std::vector<Vec3> meanNormal(n, Vec3::Zero());
  std::vector<Vec3> normal(n, Vec3::Zero());
  std::vector<char> onBoundary(n, 0);
  for (const Face f : surface.faces())
  {
    if (isTimeToAsk(static_cast<std::size_t>(f.index())) && isAsked(stop))
    {
      return result;
    }
    const Triangle& t = surface.triangle(f);
    const double area = surface.faceArea(f);
    const Vec3 faceNormal = surface.faceNormal(f);
    std::array<double, 3> cot;
    std::array<double, 3> angle;
    std::array<double, 3> squared; // of the edge opposite each corner
    int obtuse = -1;
    for (int k = 0; k < 3; ++k)
    {
      const Vec3& a = surface.point(f, k);
      const Vec3& b = surface.point(f, nextCorner(k));
      const Vec3& c = surface.point(f, previousCorner(k));
      cot[k] = cotangent(a, b, c, 1e3);
      angle[k] = std::atan2((b - a).cross(c - a).norm(), (b - a).dot(c - a));
      squared[k] = (c - b).squaredNorm();
      if (angle[k] > Pi / 2)
      {
        obtuse = k;
      }
      if (surface.isBoundary(halfedgeOf(f, k)))
      {
        onBoundary[t[k]] = onBoundary[t[nextCorner(k)]] = 1;
      }
    }
    for (int k = 0; k < 3; ++k)
    {
      const int i = nextCorner(k);
      const int j = previousCorner(k);
      result.gaussian[t[k]] -= angle[k];
      normal[t[k]] += angle[k] * faceNormal;
      // Voronoi area inside the triangle, or the safe share if the triangle is obtuse.
      result.mixedArea[t[k]] +=
        obtuse < 0 ? (cot[i] * squared[i] + cot[j] * squared[j]) / 8 : area / (obtuse == k ? 2 : 4);
      const Vec3 edge = surface.points[t[i]] - surface.points[t[j]];
      meanNormal[t[i]] += 0.5 * cot[k] * edge;
      meanNormal[t[j]] -= 0.5 * cot[k] * edge;
    }
  }
  for (std::size_t p = 0; p < n; ++p)
  {
    if (onBoundary[p])
    {
      result.gaussian[p] -= Pi;
    }
    const double area = result.mixedArea[p];
    result.gaussian[p] = area > 0 ? result.gaussian[p] / area : 0.;
    const double h = area > 0 ? 0.5 * meanNormal[p].norm() / area : 0.;
    result.mean[p] = meanNormal[p].dot(normal[p]) < 0 ? -h : h;
  }
  std::vector<double> sum(n, 0.);
  std::vector<int> count(n, 0);
  for (const Halfedge h : surface.halfedges())
  {
    const int a = surface.tail(h).index();
    const int b = surface.head(h).index();
    if (onBoundary[a] && !onBoundary[b])
    {
      sum[a] += result.mean[b];
      ++count[a];
    }
  }
  for (std::size_t p = 0; p < n; ++p)
  {
    if (onBoundary[p])
    {
      result.mean[p] = count[p] > 0 ? sum[p] / count[p] : 0.;
    }
  }
  return result;
}
}
