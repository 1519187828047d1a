// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "EdgeSwaps.h"

#include "ParallelFor.h"
#include "Tuning.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace stipple
{
namespace
{
double angleAt(const Vec3& p, const Vec3& q, const Vec3& r)
{
  const Vec3 u = q - p;
  const Vec3 v = r - p;
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

double smallestAngle(const Vec3& a, const Vec3& b, const Vec3& c)
{
  // It is opposite to the shortest edge.
  const double ab = (b - a).squaredNorm();
  const double bc = (c - b).squaredNorm();
  const double ca = (a - c).squaredNorm();
  return ab <= bc && ab <= ca ? angleAt(c, a, b) : bc <= ca ? angleAt(a, b, c) : angleAt(b, c, a);
}

double aspect(const Vec3& a, const Vec3& b, const Vec3& c)
{
  const double perimeter = (b - a).norm() + (c - b).norm() + (a - c).norm();
  return perimeter > 0 ? triangleArea(a, b, c) / (perimeter * perimeter) : 0.;
}

/// The opposite angles (in space) of an edge exceed 180 degrees together.
bool exceedsHalfTurn(const OptimizedMesh& mesh, Edge e)
{
  const auto v = mesh.wingVertices(e);
  const Vec3& a = mesh.position(v[0]);
  const Vec3& b = mesh.position(v[1]);
  const Vec3 ca = a - mesh.position(v[2]);
  const Vec3 cb = b - mesh.position(v[2]);
  const Vec3 da = a - mesh.position(v[3]);
  const Vec3 db = b - mesh.position(v[3]);
  const double cosC = ca.dot(cb);
  const double cosD = da.dot(db);
  if (cosC >= 0 && cosD >= 0)
  {
    return false;
  }
  const double sinC = ca.cross(cb).norm();
  const double sinD = da.cross(db).norm();
  return sinC * cosD + cosC * sinD <
    -Tuning::DelaunayTolerance * (ca.norm() * cb.norm() * da.norm() * db.norm());
}

/// The lesser measure of an edge's two triangles, and of those after its swap.
template <typename Measure>
std::pair<double, double> worstBeforeAndAfter(
  const OptimizedMesh& mesh, Edge e, const Measure& measure)
{
  const auto v = mesh.wingVertices(e);
  const Vec3& a = mesh.position(v[0]);
  const Vec3& b = mesh.position(v[1]);
  const Vec3& c = mesh.position(v[2]);
  const Vec3& d = mesh.position(v[3]);
  return { std::min(measure(a, b, c), measure(b, a, d)),
    std::min(measure(d, c, a), measure(c, d, b)) };
}

/// Passes over all edges in order, while something changes, for wishes that depend on an edge's two
/// triangles only: all are asked for at once, in parallel, and again only where a swap changed a
/// triangle.
template <typename Wish>
int swapWhile(MeshEdit& edit, int maximumNumberOfPasses, const Wish& wish)
{
  enum class Answer : char
  {
    No,
    Yes,
    Unknown
  };
  const OptimizedMesh& mesh = edit.mesh();
  ElementArray<Edge, Answer> answer(static_cast<std::size_t>(mesh.edges().size()));
  const auto ask = [&](Edge e) {
    answer[e] = mesh.isSwappable(e) && edit.maySwap(e) && wish(e) ? Answer::Yes : Answer::No;
  };
  parallelFor(mesh.edges(), ask);
  int total = 0;
  for (int pass = 0, swaps = 1; pass < maximumNumberOfPasses && swaps > 0; ++pass)
  {
    swaps = 0;
    for (const Edge e : mesh.edges())
    {
      if (answer[e] == Answer::Unknown)
      {
        ask(e);
      }
      // A refused swap may become possible without a change of its triangles: the answer stays.
      if (answer[e] == Answer::Yes && edit.swap(e))
      {
        ++swaps;
        answer[e] = Answer::Unknown;
        for (int side = 0; side < 2; ++side)
        {
          const Halfedge next = mesh.next(mesh.halfedge(e, side));
          answer[mesh.edge(next)] = Answer::Unknown;
          answer[mesh.edge(mesh.next(next))] = Answer::Unknown;
        }
      }
    }
    total += swaps;
  }
  return total;
}

/// Triangles of the sector of v between creases or boundaries that start is in, and its angle, if
/// that is wanted.
std::pair<int, double> sectorOf(const OptimizedMesh& mesh, Halfedge start, bool withAngle)
{
  const Vertex v = mesh.from(start);
  // Turn clockwise to the first edge of the sector, then count and measure counterclockwise.
  Halfedge first = start;
  while (!mesh.isCrease(mesh.edge(first)))
  {
    const Halfedge right = mesh.opposite(first);
    if (mesh.isBoundary(right))
    {
      break;
    }
    first = mesh.next(right);
    if (first == start)
    {
      break;
    }
  }
  int triangles = 0;
  double angle = 0;
  Halfedge h = first;
  do
  {
    const Halfedge last = mesh.previous(h);
    if (withAngle)
    {
      angle += angleAt(mesh.position(v), mesh.position(mesh.to(h)), mesh.position(mesh.from(last)));
    }
    ++triangles;
    if (mesh.isCrease(mesh.edge(last)))
    {
      break;
    }
    h = mesh.opposite(last);
  } while (h != first && !mesh.isBoundary(h));
  return { triangles, angle };
}
}

bool isDelaunaySwap(const OptimizedMesh& mesh, Edge e)
{
  return mesh.isSwappable(e) && exceedsHalfTurn(mesh, e);
}

int delaunaySwaps(MeshEdit& edit, int maximumNumberOfPasses)
{
  return swapWhile(
    edit, maximumNumberOfPasses, [&](Edge e) { return exceedsHalfTurn(edit.mesh(), e); });
}

/// In space, and with both triangles laid flat as well: over a ridge the other edge is short in
/// space, for it cuts through what is below.
bool isAspectSwap(const OptimizedMesh& mesh, Edge e)
{
  const auto [before, after] = worstBeforeAndAfter(mesh, e, aspect);
  const double wanted = (1. + Tuning::LeastGainOfAspect) * before;
  if (after <= wanted)
  {
    return false;
  }
  const auto v = mesh.wingVertices(e);
  const Vec3& origin = mesh.position(v[0]);
  const Vec3 along = mesh.position(v[1]) - origin;
  const double length = along.norm();
  const auto laidFlat = [&](const Vec3& p, double side) {
    const double x = length > 0 ? (p - origin).dot(along) / length : 0.;
    return Vec3(x, side * std::sqrt(std::max(0., (p - origin).squaredNorm() - x * x)), 0.);
  };
  const Vec3 c = laidFlat(mesh.position(v[2]), 1.);
  const Vec3 d = laidFlat(mesh.position(v[3]), -1.);
  const double height = c.y() - d.y();
  const double middle = height > 0 ? (c.y() * d.x() - d.y() * c.x()) / height : -1.;
  return middle > 0 && middle < length &&
    std::min(aspect(Vec3::Zero(), d, c), aspect(Vec3(length, 0, 0), c, d)) > wanted;
}

int aspectSwaps(MeshEdit& edit, int maximumNumberOfPasses)
{
  return swapWhile(
    edit, maximumNumberOfPasses, [&](Edge e) { return isAspectSwap(edit.mesh(), e); });
}

int regularitySwaps(MeshEdit& edit, double minimumAngle, int maximumNumberOfPasses)
{
  const OptimizedMesh& mesh = edit.mesh();
  const auto excess = [&](Halfedge h) { return valenceExcess(mesh, h); };
  const auto square = [](Vertex, int x) { return x * x; };
  const auto isWanted = [&](Edge e) {
    if (!mesh.isSwappable(e) || costChangeOfSwap(mesh, e, excess, square) >= 0)
    {
      return false;
    }
    const auto [before, after] = worstBeforeAndAfter(mesh, e, smallestAngle);
    return after > minimumAngle || after > before;
  };
  int total = 0;
  for (int pass = 0, swaps = 1; pass < maximumNumberOfPasses && swaps > 0; ++pass)
  {
    swaps = 0;
    for (const Edge e : mesh.edges())
    {
      swaps += isWanted(e) && edit.swap(e) ? 1 : 0;
    }
    total += swaps;
  }
  return total;
}

int valenceExcess(const OptimizedMesh& mesh, Halfedge start)
{
  const Vertex v = mesh.from(start);
  if (mesh.isFree(v) && !mesh.isBoundary(v))
  {
    return mesh.valence(v) - 6;
  }
  const auto [triangles, angle] = sectorOf(mesh, start, true);
  return triangles - std::max(1, static_cast<int>(std::lround(angle / (Pi / 3.))));
}

int ribExcess(const OptimizedMesh& mesh, Halfedge start)
{
  return mesh.freedom(mesh.from(start)) == Freedom::Backbone
    ? sectorOf(mesh, start, false).first - 3
    : valenceExcess(mesh, start);
}

int irregularity(int excess)
{
  const int beyond = std::abs(excess) - 1;
  return beyond > 0 ? 1 + beyond * beyond : 0;
}
}
