// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SoupOrientation.h"

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <tuple>

namespace stipple
{
namespace
{
/// The soup's triangles, matched across the edges that two of them share, whatever their
/// orientation.
class Soup
{
public:
  explicit Soup(const std::vector<Triangle>& triangles)
    : Triangles(triangles)
    , Match(3 * triangles.size())
  {
    const auto ends = [&](Halfedge h) -> std::pair<int, int> {
      return std::minmax({ this->tail(h), this->tail(nextHalfedge(h)) });
    };
    std::vector<Halfedge> order;
    for (const Halfedge h : this->Match.ids())
    {
      order.push_back(h);
    }
    std::sort(order.begin(), order.end(), [&](Halfedge g, Halfedge h) {
      return std::make_tuple(ends(g), g) < std::make_tuple(ends(h), h);
    });
    for (std::size_t i = 0, j = 0; i < order.size(); i = j)
    {
      for (j = i; j < order.size() && ends(order[j]) == ends(order[i]); ++j)
      {
      }
      if (j - i == 2)
      {
        this->Match[order[i]] = order[i + 1];
        this->Match[order[i + 1]] = order[i];
      }
    }
  }

  ElementRange<Halfedge> halfedges() const { return this->Match.ids(); }
  int tail(Halfedge h) const { return this->Triangles[faceOf(h).index()][cornerOf(h)]; }
  /// None where not exactly two triangles meet.
  Halfedge match(Halfedge h) const { return this->Match[h]; }
  /// Whether the triangles on both sides of h run along it the same way: one of them is to turn.
  bool disagree(Halfedge h) const { return this->tail(h) == this->tail(this->Match[h]); }

  /// Which triangles to turn; pairs of halfedges that end up running the same way are unmatched.
  ElementArray<Face, char> orient()
  {
    ElementArray<Face, char> turned(this->Triangles.size(), 0);
    ElementArray<Face, char> seen(this->Triangles.size(), 0);
    std::vector<Face> queue;
    for (const Face start : seen.ids())
    {
      if (seen[start])
      {
        continue;
      }
      seen[start] = 1;
      queue = { start };
      for (std::size_t i = 0; i < queue.size(); ++i)
      {
        const Face f = queue[i];
        for (const Halfedge h : halfedgesOf(f))
        {
          if (this->Match[h].valid() && !seen[faceOf(this->Match[h])])
          {
            const Face g = faceOf(this->Match[h]);
            seen[g] = 1;
            turned[g] = turned[f] != static_cast<char>(this->disagree(h));
            queue.push_back(g);
          }
        }
      }
    }
    for (const Halfedge h : this->halfedges())
    {
      const Halfedge g = this->Match[h];
      if (g.valid() && (turned[faceOf(h)] != turned[faceOf(g)]) != this->disagree(h))
      {
        this->Match[h] = this->Match[g] = {};
      }
    }
    return turned;
  }

private:
  const std::vector<Triangle>& Triangles;
  ElementArray<Halfedge, Halfedge> Match;
};
}

void orientSoup(std::vector<Triangle>& triangles, std::vector<int>& sourcePoint)
{
  Soup soup(triangles);
  const ElementArray<Face, char> turned = soup.orient();

  // Corners of a point belong together if matched edges join their triangles.
  boost::disjoint_sets_with_storage<> corners(soup.halfedges().size());
  const auto unite = [&](Halfedge g, Halfedge h) { corners.union_set(g.index(), h.index()); };
  for (const Halfedge h : soup.halfedges())
  {
    const Halfedge g = soup.match(h);
    if (g < h)
    {
      continue;
    }
    const bool same = soup.disagree(h);
    unite(h, same ? g : nextHalfedge(g));
    unite(nextHalfedge(h), same ? nextHalfedge(g) : g);
  }
  ElementArray<Halfedge, int> pointOf(soup.halfedges().size(), -1); // by root
  std::vector<char> taken(sourcePoint.size(), 0);
  for (const Halfedge c : soup.halfedges())
  {
    int& p = triangles[faceOf(c).index()][cornerOf(c)];
    int& group = pointOf[Halfedge(static_cast<int>(corners.find_set(c.index())))];
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
  for (const Face f : turned.ids())
  {
    if (turned[f])
    {
      std::swap(triangles[f.index()][1], triangles[f.index()][2]);
    }
  }
}
}
