// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SoupOrientation.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace stipple
{
namespace
{
/// The halfedge on the other side of every edge that two triangles share, whatever their
/// orientation; -1 elsewhere.
std::vector<int> matchEdges(const std::vector<Triangle>& triangles)
{
  const int n = 3 * static_cast<int>(triangles.size());
  const auto ends = [&](int h) {
    return std::minmax(triangles[h / 3][h % 3], triangles[h / 3][nextHalfedge(h) % 3]);
  };
  std::vector<int> order(n);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
    [&](int g, int h) { return std::make_tuple(ends(g), g) < std::make_tuple(ends(h), h); });
  std::vector<int> match(n, -1);
  for (int i = 0; i < n;)
  {
    int j = i;
    while (j < n && ends(order[j]) == ends(order[i]))
    {
      ++j;
    }
    if (j - i == 2)
    {
      match[order[i]] = order[i + 1];
      match[order[i + 1]] = order[i];
    }
    i = j;
  }
  return match;
}

/// Which triangles to turn; pairs of halfedges that end up running the same way are unmatched.
std::vector<char> orient(const std::vector<Triangle>& triangles, std::vector<int>& match)
{
  const int n = static_cast<int>(triangles.size());
  // Whether the triangles on both sides of h run along it the same way: one of them is to turn.
  const auto disagree = [&](int h) {
    const int g = match[h];
    return triangles[h / 3][h % 3] == triangles[g / 3][g % 3];
  };
  std::vector<char> turned(n, 0);
  std::vector<char> seen(n, 0);
  for (int start = 0; start < n; ++start)
  {
    if (seen[start])
    {
      continue;
    }
    seen[start] = 1;
    std::vector<int> queue = { start };
    for (std::size_t i = 0; i < queue.size(); ++i)
    {
      const int f = queue[i];
      for (int h = 3 * f; h < 3 * f + 3; ++h)
      {
        if (match[h] >= 0 && !seen[match[h] / 3])
        {
          const int g = match[h] / 3;
          seen[g] = 1;
          turned[g] = turned[f] != static_cast<char>(disagree(h));
          queue.push_back(g);
        }
      }
    }
  }
  for (int h = 0; h < 3 * n; ++h)
  {
    const int g = match[h];
    if (g >= 0 && (turned[h / 3] != turned[g / 3]) != disagree(h))
    {
      match[h] = match[g] = -1;
    }
  }
  return turned;
}
}

void orientSoup(std::vector<Triangle>& triangles, std::vector<int>& sourcePoint)
{
  std::vector<int> match = matchEdges(triangles);
  const std::vector<char> turned = orient(triangles, match);
  const int corners = 3 * static_cast<int>(triangles.size());

  // Corners of a point belong together if matched edges join their triangles.
  std::vector<int> parent(corners);
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int c) {
    while (parent[c] != c)
    {
      parent[c] = parent[parent[c]];
      c = parent[c];
    }
    return c;
  };
  for (int h = 0; h < corners; ++h)
  {
    const int g = match[h];
    if (g < h)
    {
      continue;
    }
    const bool same = triangles[h / 3][h % 3] == triangles[g / 3][g % 3];
    const int tail = root(same ? g : nextHalfedge(g));
    const int head = root(same ? nextHalfedge(g) : g);
    parent[tail] = root(h);
    parent[head] = root(nextHalfedge(h));
  }
  std::vector<int> pointOf(corners, -1); // by root
  std::vector<char> taken(sourcePoint.size(), 0);
  for (int c = 0; c < corners; ++c)
  {
    int& p = triangles[c / 3][c % 3];
    int& group = pointOf[root(c)];
    if (group < 0 && !taken[p])
    {
      taken[p] = 1;
      group = p;
    }
    else if (group < 0)
    {
      group = static_cast<int>(sourcePoint.size());
      sourcePoint.push_back(int(sourcePoint[p]));
    }
    p = group;
  }
  for (std::size_t f = 0; f < triangles.size(); ++f)
  {
    if (turned[f])
    {
      std::swap(triangles[f][1], triangles[f][2]);
    }
  }
}
}
