// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SoupOrientation.h"

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace stipple
{
namespace
{
/// A triangle at an edge of many, as seen along the edge.
struct Leaf
{
  Halfedge halfedge;
  bool isForward = false; ///< its triangle runs along the edge as the edge does
  double angle = 0;       ///< counterclockwise about the edge, from that of the first leaf

  static constexpr double OnePlane = 1e-6; ///< radians
};

/// One that runs backward, and one that runs forward, to be neighbours.
using LeafPair = std::pair<Halfedge, Halfedge>;

/// At an edge whose sheets go on; surfaces have three or four.
constexpr std::size_t MostLeaves = 1000;

/// Leaves that bound the same body, as in brackets: what is inside a surface lies counterclockwise
/// of a leaf that runs backward, up to one that runs forward. So bodies that meet in an edge part
/// there, and stay closed. The leaves are in order, and as many run one way as the other.
std::vector<LeafPair> pairsAroundBodies(const std::vector<Leaf>& leaves)
{
  std::vector<LeafPair> pairs;
  std::vector<Halfedge> open;
  std::vector<char> isClosed(leaves.size(), 0);
  for (std::size_t i = 0; i < 2 * leaves.size(); ++i) // twice around: brackets may begin anywhere
  {
    const std::size_t k = i % leaves.size();
    const Leaf& leaf = leaves[k];
    if (!leaf.isForward && i < leaves.size())
    {
      open.push_back(leaf.halfedge);
    }
    else if (leaf.isForward && isClosed[k] == 0 && !open.empty())
    {
      isClosed[k] = 1;
      pairs.emplace_back(open.back(), leaf.halfedge);
      open.pop_back();
    }
  }
  return pairs;
}

/// Leaves that go on in one another most nearly straight: there is no inside where one is left
/// over, but a sheet that others end on. Of very many, each pair of which is looked at, none.
std::vector<LeafPair> pairsAlongSheets(const std::vector<Leaf>& leaves)
{
  if (leaves.size() > MostLeaves)
  {
    return {};
  }
  std::vector<std::pair<double, LeafPair>> candidates;
  for (const Leaf& a : leaves)
  {
    for (const Leaf& b : leaves)
    {
      if (!a.isForward && b.isForward)
      {
        candidates.emplace_back(
          std::abs(std::abs(a.angle - b.angle) - EIGEN_PI), LeafPair(a.halfedge, b.halfedge));
      }
    }
  }
  std::sort(candidates.begin(), candidates.end(),
    [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<LeafPair> pairs;
  for (const auto& [bend, candidate] : candidates)
  {
    if (std::none_of(pairs.begin(), pairs.end(), [c = candidate](const LeafPair& pair) {
          return pair.first == c.first || pair.second == c.second;
        }))
    {
      pairs.push_back(candidate);
    }
  }
  return pairs;
}

/// The soup's triangles, matched across edges, whatever their orientation.
class Soup
{
public:
  Soup(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles)
    : Points(points)
    , Triangles(triangles)
    , Turned(triangles.size(), 0)
    , Match(3 * triangles.size())
  {
    forEachEdge(triangles, [&](auto begin, auto end) {
      if (end - begin == 2)
      {
        this->join({ begin[0], begin[1] });
      }
      else if (end - begin > 2)
      {
        this->Books.emplace_back(begin, end);
      }
    });
  }

  ElementRange<Halfedge> halfedges() const { return this->Match.ids(); }
  int tail(Halfedge h) const { return this->Triangles[faceOf(h).index()][cornerOf(h)]; }
  /// None where the surface ends.
  Halfedge match(Halfedge h) const { return this->Match[h]; }
  /// Whether the triangles on both sides of h run along it the same way: one of them is to turn.
  bool disagree(Halfedge h) const { return this->tail(h) == this->tail(this->Match[h]); }
  bool isTurned(Face f) const { return this->Turned[f] != 0; }

  /// Finds which triangles to turn, across edges of two; pairs of halfedges that end up running the
  /// same way are unmatched.
  void orient()
  {
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
            this->Turned[g] = this->Turned[f] != static_cast<char>(this->disagree(h));
            queue.push_back(g);
          }
        }
      }
    }
    for (const Halfedge h : this->halfedges())
    {
      const Halfedge g = this->Match[h];
      if (g.valid() && (this->Turned[faceOf(h)] != this->Turned[faceOf(g)]) != this->disagree(h))
      {
        this->part(h);
      }
    }
  }

  /// Matches the triangles at edges of more than two, after orient(): first those that may bound
  /// bodies, as what they are part of ends at such edges only.
  void matchBooks()
  {
    const ElementArray<Face, char> ends = this->facesOfSheetsThatEnd();
    for (const std::vector<Halfedge>& book : this->Books)
    {
      std::vector<Leaf> all = this->leavesOf(book);
      std::vector<Leaf> closed;
      std::copy_if(all.begin(), all.end(), std::back_inserter(closed),
        [&](const Leaf& leaf) { return ends[faceOf(leaf.halfedge)] == 0; });
      const auto forward = static_cast<std::size_t>(std::count_if(
        closed.begin(), closed.end(), [](const Leaf& leaf) { return leaf.isForward; }));
      for (const LeafPair& pair :
        2 * forward == closed.size() ? pairsAroundBodies(closed) : pairsAlongSheets(closed))
      {
        this->join(pair);
      }
      all.erase(std::remove_if(all.begin(), all.end(),
                  [&](const Leaf& leaf) { return this->Match[leaf.halfedge].valid(); }),
        all.end());
      for (const LeafPair& pair : pairsAlongSheets(all))
      {
        this->join(pair);
      }
    }
  }

  /// For each corner, by the halfedge that begins there, one of those that belong to the same
  /// point: matched edges join their triangles.
  ElementArray<Halfedge, Halfedge> pointsOfCorners() const
  {
    boost::disjoint_sets_with_storage<> corners(this->Match.size());
    const auto unite = [&](Halfedge g, Halfedge h) { corners.union_set(g.index(), h.index()); };
    for (const Halfedge h : this->halfedges())
    {
      const Halfedge g = this->Match[h];
      if (g < h)
      {
        continue;
      }
      const bool same = this->disagree(h);
      unite(h, same ? g : nextHalfedge(g));
      unite(nextHalfedge(h), same ? nextHalfedge(g) : g);
    }
    ElementArray<Halfedge, Halfedge> result(this->Match.size());
    for (const Halfedge h : this->halfedges())
    {
      result[h] = Halfedge(static_cast<int>(corners.find_set(h.index())));
    }
    return result;
  }

  /// Parts those triangles at edges of more than two that matching them has not: where all of one
  /// such edge comes to lie between the same two points. True if there were any.
  bool partBooks(const ElementArray<Halfedge, Halfedge>& pointOf)
  {
    bool isParted = false;
    for (const std::vector<Halfedge>& book : this->Books)
    {
      std::vector<std::pair<Halfedge, Halfedge>> edges;
      bool isMatched = false;
      for (const Halfedge h : book)
      {
        isMatched = isMatched || this->Match[h].valid();
        if (!this->Match[h].valid() || h < this->Match[h])
        {
          const std::pair<Halfedge, Halfedge> ends(pointOf[h], pointOf[nextHalfedge(h)]);
          edges.emplace_back(std::minmax(ends.first, ends.second));
        }
      }
      std::sort(edges.begin(), edges.end());
      if (isMatched && std::adjacent_find(edges.begin(), edges.end()) != edges.end())
      {
        std::for_each(book.begin(), book.end(), [&](Halfedge h) { this->part(h); });
        isParted = true;
      }
    }
    return isParted;
  }

private:
  /// Those of parts, held together by edges of two triangles, that have an edge of one.
  ElementArray<Face, char> facesOfSheetsThatEnd() const
  {
    ElementArray<Halfedge, char> isInBook(this->Match.size(), 0);
    for (const std::vector<Halfedge>& book : this->Books)
    {
      std::for_each(book.begin(), book.end(), [&](Halfedge h) { isInBook[h] = 1; });
    }
    ElementArray<Face, char> ends(this->Triangles.size(), 0);
    std::vector<Face> stack;
    const auto reach = [&](Face f) {
      if (ends[f] == 0)
      {
        ends[f] = 1;
        stack.push_back(f);
      }
    };
    for (const Halfedge h : this->halfedges())
    {
      if (!this->Match[h].valid() && isInBook[h] == 0)
      {
        reach(faceOf(h));
      }
    }
    while (!stack.empty())
    {
      const Face f = stack.back();
      stack.pop_back();
      for (const Halfedge h : halfedgesOf(f))
      {
        if (this->Match[h].valid())
        {
          reach(faceOf(this->Match[h]));
        }
      }
    }
    return ends;
  }
  void join(const LeafPair& pair)
  {
    this->Match[pair.first] = pair.second;
    this->Match[pair.second] = pair.first;
  }
  void part(Halfedge h)
  {
    if (const Halfedge g = this->Match[h]; g.valid())
    {
      this->Match[h] = this->Match[g] = {};
    }
  }
  /// In order, counterclockwise about the edge; where two lie in one plane, those that run forward
  /// first: they are the wall between two bodies.
  std::vector<Leaf> leavesOf(const std::vector<Halfedge>& book) const
  {
    const int from = std::min(this->tail(book[0]), this->tail(nextHalfedge(book[0])));
    const int to = std::max(this->tail(book[0]), this->tail(nextHalfedge(book[0])));
    const Vec3 axis = (this->Points[to] - this->Points[from]).normalized();
    const auto across = [&](Halfedge h) {
      const Vec3 d = this->Points[this->tail(nextHalfedge(nextHalfedge(h)))] - this->Points[from];
      return Vec3(d - d.dot(axis) * axis);
    };
    const Vec3 first = across(book[0]);
    const Vec3 second = axis.cross(first);
    std::vector<Leaf> leaves;
    for (const Halfedge h : book)
    {
      const Vec3 d = across(h);
      double angle = std::atan2(d.dot(second), d.dot(first));
      angle += angle < -Leaf::OnePlane ? 2. * EIGEN_PI : 0.;
      leaves.push_back({ h, (this->tail(h) == from) != this->isTurned(faceOf(h)), angle });
    }
    std::sort(
      leaves.begin(), leaves.end(), [](const Leaf& a, const Leaf& b) { return a.angle < b.angle; });
    for (std::size_t i = 0, j = 0; i < leaves.size(); i = j)
    {
      for (j = i; j < leaves.size() && leaves[j].angle - leaves[i].angle <= Leaf::OnePlane; ++j)
      {
      }
      std::stable_partition(leaves.begin() + static_cast<std::ptrdiff_t>(i),
        leaves.begin() + static_cast<std::ptrdiff_t>(j),
        [](const Leaf& leaf) { return leaf.isForward; });
    }
    return leaves;
  }

  const std::vector<Vec3>& Points;
  const std::vector<Triangle>& Triangles;
  ElementArray<Face, char> Turned;
  ElementArray<Halfedge, Halfedge> Match;
  std::vector<std::vector<Halfedge>> Books; ///< edges of more than two triangles
};
}

void orientSoup(
  const std::vector<Vec3>& points, std::vector<Triangle>& triangles, std::vector<int>& sourcePoint)
{
  Soup soup(points, triangles);
  soup.orient();
  soup.matchBooks();
  ElementArray<Halfedge, Halfedge> pointOf = soup.pointsOfCorners();
  if (soup.partBooks(pointOf)) // all at once: points are split by it, which joins no other edges
  {
    pointOf = soup.pointsOfCorners();
  }

  ElementArray<Halfedge, int> idOf(soup.halfedges().size(), -1);
  std::vector<char> taken(sourcePoint.size(), 0);
  for (const Halfedge c : soup.halfedges())
  {
    int& p = triangles[faceOf(c).index()][cornerOf(c)];
    int& id = idOf[pointOf[c]];
    if (id < 0 && !taken[p])
    {
      taken[p] = 1;
      id = p;
    }
    else if (id < 0)
    {
      id = static_cast<int>(sourcePoint.size());
      sourcePoint.push_back(int(sourcePoint[p]));
    }
    p = id;
  }
  for (std::size_t f = 0; f < triangles.size(); ++f)
  {
    if (soup.isTurned(Face(static_cast<int>(f))))
    {
      std::swap(triangles[f][1], triangles[f][2]);
    }
  }
}
}
