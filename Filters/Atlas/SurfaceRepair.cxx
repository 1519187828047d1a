// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceRepair.h"

#include "AtlasConstants.h"
#include "DegenerateFaces.h"
#include "FaceSets.h"
#include "PolyDataConversion.h"
#include "SoupOrientation.h"
#include "ThinTriangles.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <sstream>
#include <string>

namespace stipple
{
using Constants = AtlasConstants;

namespace
{
/// Of the bounding box. Its diagonal's square might leave the range of double precision.
double largestSide(const TriangleSurface& surface)
{
  if (surface.triangles.empty())
  {
    return 0;
  }
  Vec3 low = surface.point(Face(0), 0);
  Vec3 high = low;
  for (const Triangle& t : surface.triangles)
  {
    for (int p : t)
    {
      low = low.cwiseMin(surface.points[p]);
      high = high.cwiseMax(surface.points[p]);
    }
  }
  return (high - low).maxCoeff();
}

std::string shortNumber(double x)
{
  std::ostringstream text;
  text << std::setprecision(3) << x;
  return text.str();
}

/// Whether the triangles about a point close a fan, all oriented alike, without an edge to a point
/// at the same place: then the surface wants nothing of other points that are there, too.
std::vector<char> haveClosedFans(const TriangleSurface& surface)
{
  const auto twin = halfedgeTwins(surface.triangles);
  const std::size_t n = surface.points.size();
  ElementArray<Vertex, Halfedge> outgoing(n);
  ElementArray<Vertex, int> number(n, 0);
  std::vector<char> isClosed(n, 1);
  for (const Halfedge h : surface.halfedges())
  {
    const Vertex p = surface.tail(h);
    const Vertex q = surface.head(h);
    outgoing[p] = h;
    ++number[p];
    if (!twin[h].valid() || surface.point(p) == surface.point(q))
    {
      isClosed[p.index()] = isClosed[q.index()] = 0;
    }
  }
  for (const Vertex p : surface.vertices())
  {
    char& closed = isClosed[p.index()];
    int turned = 0;
    for (Halfedge h = outgoing[p]; closed && h.valid();)
    {
      ++turned;
      h = twin[previousHalfedge(h)];
      if (h == outgoing[p])
      {
        break;
      }
    }
    closed = closed && number[p] > 0 && turned == number[p];
  }
  return isClosed;
}

/// The points, those at exactly the same place (-0 equals 0) behind one another, the first one
/// first.
std::vector<int> orderByPlace(const std::vector<Vec3>& points)
{
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    for (int k = 0; k < 3; ++k)
    {
      if (points[a][k] != points[b][k])
      {
        return points[a][k] < points[b][k];
      }
    }
    return a < b;
  });
  return order;
}

/// The representative of every point, of those in the order by place: the first one at exactly the
/// same place, those with closed fans left out.
std::vector<int> weldMap(const TriangleSurface& surface, const std::vector<int>& order)
{
  const std::vector<Vec3>& points = surface.points;
  const auto isSame = [&](int a, int b) { return points[a] == points[b]; };
  std::vector<int> map(points.size());
  std::iota(map.begin(), map.end(), 0);
  if (std::adjacent_find(order.begin(), order.end(), isSame) == order.end())
  {
    return map;
  }
  const std::vector<char> isClosed = haveClosedFans(surface);
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end)
  {
    int first = -1;
    for (end = begin; end < order.size() && isSame(order[end], order[begin]); ++end)
    {
      if (const int p = order[end]; !isClosed[p])
      {
        first = first < 0 ? p : first;
        map[p] = first;
      }
    }
  }
  return map;
}

/// How far apart points can be that were computed by different formulas, and would else be one. In
/// single precision each coordinate is off by a unit in the last place at most, which makes less
/// than two units of the largest coordinate. Numbers in double precision may have been single ones
/// before they were turned and moved: then it was the surface's size that they were rounded by.
double roundingOf(const TriangleSurface& surface)
{
  double largest = 0;
  bool single = true;
  for (const Vec3& p : surface.points)
  {
    largest = std::max(largest, p.cwiseAbs().maxCoeff());
    single = single && p.cast<float>().cast<double>() == p;
  }
  return 2. *
    std::max(std::numeric_limits<float>::epsilon() * (single ? largest : largestSide(surface)),
      8. * std::numeric_limits<double>::epsilon() * largest);
}

/// For every point, itself or one on an open edge, too, that rounding alone keeps from its place:
/// the seam of a closed parametric surface, whose two sides were computed by different formulas.
/// Empty if there are none.
std::vector<int> weldOpenEdges(const TriangleSurface& surface)
{
  std::vector<int> open;
  for (const Halfedge h : surface.halfedges())
  {
    if (surface.isBoundary(h))
    {
      open.push_back(surface.tail(h).index());
      open.push_back(surface.head(h).index());
    }
  }
  std::sort(open.begin(), open.end());
  open.erase(std::unique(open.begin(), open.end()), open.end());
  const double near = open.empty() ? 0. : roundingOf(surface);
  // Two points that near are in the same cell of a lattice, or in cells side by side.
  using Cell = std::array<long long, 3>;
  const auto cellOf = [&](int p) {
    Cell cell;
    for (int k = 0; k < 3; ++k)
    {
      cell[k] = static_cast<long long>(std::floor(surface.points[p][k] / near));
    }
    return cell;
  };
  std::map<Cell, std::vector<int>> cells;
  std::vector<int> map(surface.points.size());
  std::iota(map.begin(), map.end(), 0);
  bool any = false;
  for (std::size_t i = 0; near > 0 && i < open.size(); ++i)
  {
    const int p = open[i];
    const Cell at = cellOf(p);
    for (int side = 0; side < 27 && map[p] == p; ++side)
    {
      const auto found =
        cells.find({ at[0] + side % 3 - 1, at[1] + side / 3 % 3 - 1, at[2] + side / 9 - 1 });
      if (found == cells.end())
      {
        continue;
      }
      for (const int q : found->second)
      {
        if ((surface.points[p] - surface.points[q]).norm() <= near)
        {
          map[p] = q;
          any = true;
          break;
        }
      }
    }
    if (map[p] == p)
    {
      cells[at].push_back(p);
    }
  }
  return any ? map : std::vector<int>();
}

Triangle sorted(Triangle t)
{
  std::sort(t.begin(), t.end());
  return t;
}

/// Drops triangles with a repeated corner, and all but the first copy of each triangle.
void dropRepeated(RepairedSurface& r)
{
  std::vector<int> order(r.surface.triangles.size());
  std::iota(order.begin(), order.end(), 0);
  std::vector<Triangle> key(order.size());
  std::transform(r.surface.triangles.begin(), r.surface.triangles.end(), key.begin(), sorted);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return key[a] < key[b]; });
  std::vector<char> keep(order.size(), 1);
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const Triangle& t = key[order[i]];
    if (t[0] == t[1] || t[1] == t[2])
    {
      keep[order[i]] = 0;
      ++r.counts.degenerateTriangles;
    }
    else if (i > 0 && key[order[i - 1]] == t)
    {
      keep[order[i]] = 0;
      ++r.counts.duplicateTriangles;
    }
  }
  std::size_t n = 0;
  for (std::size_t f = 0; f < keep.size(); ++f)
  {
    if (keep[f])
    {
      r.surface.triangles[n] = r.surface.triangles[f];
      r.sourceCell[n++] = r.sourceCell[f];
    }
  }
  r.surface.triangles.resize(n);
  r.sourceCell.resize(n);
}

/// By triangle, its part of those that hang together by points, numbered as parts begin.
std::vector<int> partsOf(const TriangleSurface& s)
{
  std::vector<int> parent(s.points.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&parent](int p) {
    while (parent[p] != p)
    {
      p = parent[p] = parent[parent[p]];
    }
    return p;
  };
  for (const Triangle& t : s.triangles)
  {
    parent[root(t[1])] = root(t[0]);
    parent[root(t[2])] = root(t[0]);
  }
  std::vector<int> part(s.points.size(), -1);
  std::vector<int> result;
  int number = 0;
  for (const Triangle& t : s.triangles)
  {
    int& of = part[root(t[0])];
    of = of < 0 ? number++ : of;
    result.push_back(of);
  }
  return result;
}

/// Drops parts of which each triangle is there before, corner by corner at the same places: a sheet
/// that is in a file twice, each time with points of its own, would be welded along its rim alone.
void dropCopies(RepairedSurface& r, const std::vector<int>& order)
{
  TriangleSurface& s = r.surface;
  std::vector<int> place(s.points.size());
  bool any = false;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const bool isSame = i > 0 && s.points[order[i]] == s.points[order[i - 1]];
    place[order[i]] = isSame ? place[order[i - 1]] : order[i];
    any = any || isSame;
  }
  if (!any)
  {
    return;
  }
  std::vector<std::pair<Triangle, int>> byPlaces;
  for (std::size_t f = 0; f < s.triangles.size(); ++f)
  {
    const Triangle& t = s.triangles[f];
    byPlaces.emplace_back(
      sorted({ { place[t[0]], place[t[1]], place[t[2]] } }), static_cast<int>(f));
  }
  std::sort(byPlaces.begin(), byPlaces.end());
  const std::vector<int> part = partsOf(s);
  // What has a triangle that is in no part before is no copy. The first part that has a triangle is
  // none, so that nothing is lost.
  std::vector<char> isCopy(part.size(), 0); // by part
  std::vector<char> isNew(part.size(), 0);
  for (std::size_t begin = 0, end = 0; begin < byPlaces.size(); begin = end)
  {
    const Triangle& t = byPlaces[begin].first;
    int first = part[byPlaces[begin].second];
    for (end = begin; end < byPlaces.size() && byPlaces[end].first == t; ++end)
    {
      first = std::min(first, part[byPlaces[end].second]);
    }
    const bool isDegenerate = t[0] == t[1] || t[1] == t[2]; // it tells nothing
    for (std::size_t k = begin; k < end && !isDegenerate; ++k)
    {
      const int own = part[byPlaces[k].second];
      (own > first ? isCopy : isNew)[own] = 1;
    }
  }
  std::size_t kept = 0;
  for (std::size_t f = 0; f < part.size(); ++f)
  {
    if (isCopy[part[f]] != 0 && isNew[part[f]] == 0)
    {
      ++r.counts.duplicateTriangles;
      continue;
    }
    s.triangles[kept] = s.triangles[f];
    r.sourceCell[kept++] = r.sourceCell[f];
  }
  s.triangles.resize(kept);
  r.sourceCell.resize(kept);
}

/// Number of edges that more than two triangles share.
int countNonManifoldEdges(const std::vector<Triangle>& triangles)
{
  std::vector<std::array<int, 2>> edges;
  edges.reserve(3 * triangles.size());
  for (const Triangle& t : triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      edges.push_back({ std::min(t[k], t[nextCorner(k)]), std::max(t[k], t[nextCorner(k)]) });
    }
  }
  std::sort(edges.begin(), edges.end());
  int count = 0;
  for (std::size_t i = 0; i < edges.size();)
  {
    std::size_t j = i;
    while (j < edges.size() && edges[j] == edges[i])
    {
      ++j;
    }
    count += j - i > 2;
    i = j;
  }
  return count;
}

/// Keeps, for every component, the orientation that most of its triangles came with.
void restoreMajorityOrientation(RepairedSurface& r, const std::vector<Triangle>& before)
{
  TriangleSurface& s = r.surface;
  const auto turned = [&](Face f) {
    // Same cyclic order of source points as before?
    Triangle t;
    for (int k = 0; k < 3; ++k)
    {
      t[k] = r.sourcePoint[s.vertex(f, k).index()];
    }
    const Triangle& o = before[f.index()];
    for (int k = 0; k < 3; ++k)
    {
      if (t[k] == o[0] && t[nextCorner(k)] == o[1])
      {
        return false;
      }
    }
    return true;
  };
  for (const std::vector<Face>& component : FaceSets(s, [](Halfedge) { return true; }).faces())
  {
    int count = static_cast<int>(std::count_if(component.begin(), component.end(), turned));
    const int size = static_cast<int>(component.size());
    if (2 * count > size)
    {
      for (const Face f : component)
      {
        std::swap(s.triangles[f.index()][1], s.triangles[f.index()][2]);
      }
      count = size - count;
    }
    r.counts.reorientedTriangles += count;
  }
  s.connect();
}

/// The corners as points of the input, which have copies.
std::vector<Triangle> sourceTriangles(const RepairedSurface& r)
{
  std::vector<Triangle> result = r.surface.triangles;
  for (Triangle& t : result)
  {
    for (int& p : t)
    {
      p = r.sourcePoint[p];
    }
  }
  return result;
}

/// Edges of two triangles that come of one of more.
std::vector<Halfedge> jointsOf(const RepairedSurface& r)
{
  std::vector<Halfedge> joints;
  forEachEdge(sourceTriangles(r), [&](auto begin, auto end) {
    if (end - begin > 2)
    {
      std::copy_if(
        begin, end, std::back_inserter(joints), [&](Halfedge h) { return r.surface.twin[h] > h; });
    }
  });
  return joints;
}

/// Forgets points that no triangle uses.
void compactPoints(RepairedSurface& r)
{
  std::vector<int> newId(r.surface.points.size(), -1);
  std::vector<Vec3> points;
  std::vector<int> source;
  for (const Triangle& t : r.surface.triangles)
  {
    for (int p : t)
    {
      newId[p] = 0;
    }
  }
  for (std::size_t p = 0; p < newId.size(); ++p)
  {
    if (newId[p] == 0)
    {
      newId[p] = static_cast<int>(points.size());
      points.push_back(r.surface.points[p]);
      source.push_back(r.sourcePoint[p]);
    }
  }
  for (Triangle& t : r.surface.triangles)
  {
    for (int& p : t)
    {
      p = newId[p];
    }
  }
  r.surface.points = std::move(points);
  r.sourcePoint = std::move(source);
}

/// Welds open edges that are apart by rounding alone. `weld`, the representatives of the input's
/// points, follows.
void weldSeams(RepairedSurface& r, std::vector<int>& weld)
{
  TriangleSurface& s = r.surface;
  const std::vector<int> map = weldOpenEdges(s);
  if (map.empty())
  {
    return;
  }
  std::vector<int> representative(weld.size());
  std::iota(representative.begin(), representative.end(), 0);
  for (std::size_t p = 0; p < map.size(); ++p)
  {
    representative[r.sourcePoint[p]] = r.sourcePoint[map[p]];
    r.counts.weldedPoints += map[p] != static_cast<int>(p);
  }
  for (int& p : weld)
  {
    p = representative[p];
  }
  for (Triangle& t : s.triangles)
  {
    for (int& p : t)
    {
      p = map[p];
    }
  }
  dropRepeated(r);
  compactPoints(r);
  s.connect();
}
}

Status repairSurface(vtkPolyData* input, RepairedSurface& r, const Progress& progress)
{
  r = {};
  // Steps of about the same time.
  constexpr double Steps = 8;
  double done = 0;
  const auto isAborted = [&] { return !report(progress, ++done / Steps); };
  if (Status status = readPolyData(input, r.surface, &r.sourceCell); !status.ok())
  {
    return status;
  }
  TriangleSurface& s = r.surface;
  for (std::size_t p = 0; p < s.points.size(); ++p)
  {
    if (!s.points[p].allFinite())
    {
      return Status::error("Point " + std::to_string(p) +
        " of the input has a coordinate that is not a finite number: remove or correct it.");
    }
  }
  const double size = largestSide(s);
  if (size > 0 && (size < Constants::SmallestSize || size > Constants::LargestSize))
  {
    return Status::error("The surface is " + shortNumber(size) + " across: scale it to between " +
      shortNumber(Constants::SmallestSize) + " and " + shortNumber(Constants::LargestSize) + ".");
  }
  const int numberOfInputPoints = static_cast<int>(s.points.size());
  if (isAborted())
  {
    return Status::aborted();
  }
  std::vector<char> used(numberOfInputPoints, 0);
  for (const Triangle& t : s.triangles)
  {
    used[t[0]] = used[t[1]] = used[t[2]] = 1;
  }
  const std::vector<int> order = orderByPlace(s.points);
  dropCopies(r, order);
  std::vector<int> weld = weldMap(s, order);
  if (isAborted())
  {
    return Status::aborted();
  }
  for (Triangle& t : s.triangles)
  {
    for (int& p : t)
    {
      p = weld[p];
    }
  }
  for (int p = 0; p < numberOfInputPoints; ++p)
  {
    r.counts.unusedPoints += !used[p];
    r.counts.weldedPoints += used[p] && weld[p] != p;
  }
  r.sourcePoint.resize(numberOfInputPoints);
  std::iota(r.sourcePoint.begin(), r.sourcePoint.end(), 0);

  dropRepeated(r);
  compactPoints(r);
  if (isAborted())
  {
    return Status::aborted();
  }
  s.connect();
  weldSeams(r, weld);
  if (s.triangles.empty())
  {
    return Status::success();
  }
  if (isAborted())
  {
    return Status::aborted();
  }
  // The usual input is clean already: only the others pay for the orienter.
  if (!s.topology().manifold)
  {
    r.counts.splitEdges = countNonManifoldEdges(s.triangles);
    const std::vector<Triangle> before = sourceTriangles(r);
    if (isAborted())
    {
      return Status::aborted();
    }
    const std::vector<int> original = r.sourcePoint;
    std::vector<int> index(s.points.size());
    std::iota(index.begin(), index.end(), 0);
    orientSoup(s.points, s.triangles, index);
    r.counts.splitVertices = static_cast<int>(index.size() - s.points.size());
    for (std::size_t p = s.points.size(); p < index.size(); ++p)
    {
      s.points.push_back(Vec3(s.points[index[p]]));
      r.sourcePoint.push_back(original[index[p]]);
    }
    s.connect();
    restoreMajorityOrientation(r, before);
    compactPoints(r);
  }
  if (isAborted())
  {
    return Status::aborted();
  }
  if (const int thin = removeThinTriangles(s, r.sourceCell); thin > 0)
  {
    r.counts.degenerateTriangles += thin;
    compactPoints(r); // CGAL asks for a mesh without points of no triangle
    removeDegenerateFaces(s, r.sourcePoint, r.sourceCell); // what single steps could not
    compactPoints(r);
  }
  if (isAborted())
  {
    return Status::aborted();
  }
  s.connect();
  r.joints = r.counts.splitEdges > 0 ? jointsOf(r) : std::vector<Halfedge>();
  if (isAborted())
  {
    return Status::aborted();
  }
  r.pointOfInput.assign(numberOfInputPoints, -1);
  for (std::size_t p = s.points.size(); p-- > 0;)
  {
    r.pointOfInput[r.sourcePoint[p]] = static_cast<int>(p);
  }
  for (int p = 0; p < numberOfInputPoints; ++p)
  {
    r.pointOfInput[p] = r.pointOfInput[weld[p]];
  }
  if (!s.topology().manifold)
  {
    return Status::error(
      "The surface could not be made manifold: repair it first, for example with MeshLab.");
  }
  return Status::success();
}
}
