// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureDetection.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace stipple
{
namespace
{
constexpr double Pi = 3.14159265358979323846;

struct Edge
{
  int halfedge;
  int a;
  int b;
  bool strong;
};

/// Edges at every surface point.
std::vector<std::vector<int>> incidence(const std::vector<Edge>& edges, std::size_t numberOfPoints)
{
  std::vector<std::vector<int>> at(numberOfPoints);
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    at[edges[e].a].push_back(static_cast<int>(e));
    at[edges[e].b].push_back(static_cast<int>(e));
  }
  return at;
}
}

void detectFeatures(CutSurface& surface, const FeatureDetectionOptions& options)
{
  if (options.angle >= 180)
  {
    return;
  }
  const double strong = std::cos(options.angle * Pi / 180);
  const double weak = std::cos(options.angle * options.weakFraction * Pi / 180);
  std::vector<Edge> edges;
  for (int h = 0; h < 3 * surface.numberOfFaces(); ++h)
  {
    if (surface.twin[h] > h)
    {
      const double c = surface.faceNormal(h / 3).dot(surface.faceNormal(surface.twin[h] / 3));
      if (c <= weak)
      {
        edges.push_back({ h, surface.tail(h), surface.head(h), c <= strong });
      }
    }
  }
  const auto at = incidence(edges, surface.points.size());
  const auto direction = [&](const Edge& e, int from) -> Vec3 {
    const Vec3 d = surface.points[e.a == from ? e.b : e.a] - surface.points[from];
    return d.normalized();
  };
  // Hysteresis: a weak edge belongs if it continues a chain of sharp edges straight on.
  std::vector<char> accepted(edges.size(), 0);
  std::vector<int> queue;
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    if (edges[e].strong)
    {
      accepted[e] = 1;
      queue.push_back(static_cast<int>(e));
    }
  }
  const double straight = std::cos(35 * Pi / 180);
  for (std::size_t i = 0; i < queue.size(); ++i)
  {
    const Edge& e = edges[queue[i]];
    for (int p : { e.a, e.b })
    {
      int valence = 0;
      int best = -1;
      double bestCosine = straight;
      for (int other : at[p])
      {
        valence += accepted[other];
        const double c = -direction(e, p).dot(direction(edges[other], p));
        if (!accepted[other] && c > bestCosine)
        {
          best = other;
          bestCosine = c;
        }
      }
      if (valence == 1 && best >= 0)
      {
        accepted[best] = 1;
        queue.push_back(best);
      }
    }
  }
  // Connected sets: short ones and zigzags are noise of a scan, not creases.
  const double diagonal = surface.boundingBoxDiagonal();
  std::vector<char> seen(edges.size(), 0);
  for (std::size_t start = 0; start < edges.size(); ++start)
  {
    if (!accepted[start] || seen[start])
    {
      continue;
    }
    std::vector<int> set = { static_cast<int>(start) };
    seen[start] = 1;
    double length = 0;
    double turn = 0;
    int turns = 0;
    for (std::size_t i = 0; i < set.size(); ++i)
    {
      const Edge& e = edges[set[i]];
      length += (surface.points[e.a] - surface.points[e.b]).norm();
      for (int p : { e.a, e.b })
      {
        double straightest = -1;
        for (int other : at[p])
        {
          if (other == set[i] || !accepted[other])
          {
            continue;
          }
          straightest = std::max(straightest, -direction(e, p).dot(direction(edges[other], p)));
          if (!seen[other])
          {
            seen[other] = 1;
            set.push_back(other);
          }
        }
        if (straightest > -1)
        {
          turn += std::acos(std::clamp(straightest, -1., 1.)) * 180 / Pi;
          ++turns;
        }
      }
    }
    const bool crease = length >= options.minimumLength * diagonal &&
      (turns == 0 || turn / turns <= options.minimumMeanTurn);
    for (int e : set)
    {
      if (crease)
      {
        surface.setSharp(edges[e].halfedge, true);
      }
    }
  }
}
}
