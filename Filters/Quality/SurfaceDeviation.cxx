// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceDeviation.h"

#include "ReportingThread.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace stipple
{
namespace
{
/// A convex piece of a triangle.
struct Piece
{
  static constexpr int MostCorners = 12;
  std::array<Vec3, MostCorners> corner;
  int corners = 0;
  int near = -1; ///< a triangle of the other surface that is not far

  void add(const Vec3& p) { this->corner[this->corners++] = p; }
  Vec3 middle() const
  {
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < this->corners; ++i)
    {
      sum += this->corner[i];
    }
    return sum / this->corners;
  }
};

/// The parts of a piece on both sides of a plane; a part may be empty.
void split(const Piece& piece, const Vec3& origin, const Vec3& normal, Piece& in, Piece& out)
{
  in.corners = out.corners = 0;
  in.near = out.near = piece.near;
  std::array<double, Piece::MostCorners> height;
  for (int i = 0; i < piece.corners; ++i)
  {
    height[i] = normal.dot(piece.corner[i] - origin);
  }
  for (int i = 0; i < piece.corners; ++i)
  {
    const int j = i + 1 < piece.corners ? i + 1 : 0;
    const bool inside = height[i] >= 0;
    (inside ? in : out).add(piece.corner[i]);
    if (inside != (height[j] >= 0))
    {
      const double t = height[i] / (height[i] - height[j]);
      const Vec3 cut = piece.corner[i] + t * (piece.corner[j] - piece.corner[i]);
      in.add(cut);
      out.add(cut);
    }
  }
}

/// Looks at one triangle after the other.
class Deviation
{
public:
  Deviation(const NearestTriangle& to, double accuracy)
    : To(to)
    , Accuracy(accuracy)
  {
  }

  DeviationBounds of(const TriangleSurface& from, int face, double lower)
  {
    this->Bounds = { lower, 0. };
    this->Pieces.clear();
    Piece whole;
    for (int k = 0; k < 3; ++k)
    {
      whole.add(from.point(face, k));
    }
    this->Pieces.push_back(whole);
    for (int looks = 0; !this->Pieces.empty(); ++looks)
    {
      const Piece piece = this->Pieces.back();
      this->Pieces.pop_back();
      this->look(piece, looks < MostLooks);
    }
    return this->Bounds;
  }

private:
  /// A bound on the time where nothing else is: what is left then is as far as it may be.
  static constexpr int MostLooks = 1000000;
  /// Corners from which on a piece is halved rather than cut to a prism, which may add three.
  static constexpr int ManyCorners = 8;
  /// A piece so many times as large as the triangle under it is halved.
  static constexpr double MuchLarger = 4.;

  /// No place of the piece is farther: the distance to a convex set is convex.
  double farthestCorner(const Piece& piece, int face) const
  {
    double squared = 0;
    for (int i = 0; i < piece.corners; ++i)
    {
      squared = std::max(squared, this->To.squaredDistance(piece.corner[i], face));
    }
    return std::sqrt(squared);
  }

  void look(Piece piece, bool mayCut)
  {
    const Vec3 middle = piece.middle();
    const NearestTriangle::Hit hit = this->To.find(middle, piece.near);
    const double distance = std::sqrt(hit.squaredDistance);
    this->Bounds.lower = std::max(this->Bounds.lower, distance);
    double radius = 0;
    int farthest = 0;
    for (int i = 0; i < piece.corners; ++i)
    {
      const double r = (piece.corner[i] - middle).norm();
      farthest = r > radius ? i : farthest;
      radius = std::max(radius, r);
    }
    double most = std::min(distance + radius, this->farthestCorner(piece, hit.face));
    if (piece.near >= 0 && piece.near != hit.face)
    {
      most = std::min(most, this->farthestCorner(piece, piece.near));
    }
    if (most <= 1.01 * this->Bounds.lower + this->Accuracy || !mayCut)
    {
      this->Bounds.upper = std::max(this->Bounds.upper, most);
      return;
    }
    piece.near = hit.face;
    const TriangleSurface& to = this->To.surface();
    double width = 0;
    for (int k = 0; k < 3; ++k)
    {
      width = std::max(width, to.edgeLength(halfedgeOf(Face(hit.face), k)));
    }
    if (piece.corners > ManyCorners || radius > MuchLarger * width ||
      !this->cutToPrism(piece, Face(hit.face)))
    {
      this->halve(piece, middle, piece.corner[farthest] - middle);
    }
  }

  void push(const Piece& piece)
  {
    if (piece.corners > 0)
    {
      this->Pieces.push_back(piece);
    }
  }

  /// What lies over the triangle, and what lies beyond each of its edges; false if that is all on
  /// one side, but for half of the accuracy.
  bool cutToPrism(const Piece& piece, Face face)
  {
    const TriangleSurface& to = this->To.surface();
    const Vec3 normal = to.faceNormal(face);
    Piece inside = piece;
    Piece beyond;
    Piece rest;
    const std::size_t before = this->Pieces.size();
    for (const Halfedge h : halfedgesOf(face))
    {
      const Vec3& origin = to.point(to.tail(h));
      const Vec3 inwards = normal.cross(to.edge(h)).normalized();
      double highest = 0;
      double deepest = 0;
      for (int i = 0; i < inside.corners; ++i)
      {
        const double height = inwards.dot(inside.corner[i] - origin);
        highest = std::max(highest, height);
        deepest = std::max(deepest, -height);
      }
      if (highest <= 0.5 * this->Accuracy)
      {
        this->Pieces.resize(before);
        return false;
      }
      if (deepest <= 0.5 * this->Accuracy)
      {
        continue;
      }
      split(inside, origin, inwards, rest, beyond);
      this->push(beyond);
      inside = rest;
    }
    if (this->Pieces.size() == before)
    {
      return false;
    }
    this->push(inside);
    return true;
  }

  void halve(const Piece& piece, const Vec3& middle, const Vec3& direction)
  {
    Piece one;
    Piece other;
    split(piece, middle, direction, one, other);
    this->push(one);
    this->push(other);
  }

  const NearestTriangle& To;
  const double Accuracy;
  DeviationBounds Bounds;
  std::vector<Piece> Pieces;
};

/// What rounding leaves of lengths where coordinates are so large: finer than this, cutting has no
/// end.
double roundingOf(const TriangleSurface& a, const TriangleSurface& b)
{
  constexpr double Roundings = 64; // of one cut after another
  double largest = 0;
  for (const TriangleSurface* surface : { &a, &b })
  {
    for (const Vec3& p : surface->points)
    {
      largest = std::max(largest, p.cwiseAbs().maxCoeff());
    }
  }
  return Roundings * std::numeric_limits<double>::epsilon() * largest;
}

/// Calls visit(begin, end) for blocks of elements, on all threads; returns what is largest.
template <typename Visit>
Status forBlocks(
  int size, const Progress& progress, double from, double to, DeviationBounds& bounds, Visit visit)
{
  constexpr int Block = 256;
  const int blocks = (size + Block - 1) / Block;
  std::vector<DeviationBounds> ofBlock(blocks);
  const Status status = reportingFor(blocks, progress, from, to,
    [&](int i, const Stop&) { ofBlock[i] = visit(Block * i, std::min(size, Block * (i + 1))); });
  for (const DeviationBounds& b : ofBlock)
  {
    bounds.lower = std::max(bounds.lower, b.lower);
    bounds.upper = std::max(bounds.upper, b.upper);
  }
  return status;
}
}

Status oneSidedDeviation(const TriangleSurface& from, const NearestTriangle& to, double accuracy,
  const Progress& progress, DeviationBounds& bounds)
{
  bounds = {};
  if (from.triangles.empty() || to.surface().triangles.empty())
  {
    return Status::success();
  }
  return runReporting(progress, [&](const Progress& inner) {
    // First a good lower bound for all: what is not farther need not be cut.
    std::vector<int> firstUse(from.points.size(), -1);
    for (int f = from.numberOfFaces() - 1; f >= 0; --f)
    {
      for (const int p : from.triangles[f])
      {
        firstUse[p] = f;
      }
    }
    Status status =
      forBlocks(from.numberOfFaces(), inner, 0., 0.3, bounds, [&](int begin, int end) {
        DeviationBounds block;
        int hint = -1;
        for (int f = begin; f < end; ++f)
        {
          for (const int p : from.triangles[f])
          {
            if (firstUse[p] == f)
            {
              const NearestTriangle::Hit hit = to.find(from.points[p], hint);
              block.lower = std::max(block.lower, std::sqrt(hit.squaredDistance));
              hint = hit.face;
            }
          }
        }
        return block;
      });
    if (!status.ok())
    {
      return status;
    }
    const double start = bounds.lower;
    const double reachable = std::max(accuracy, roundingOf(from, to.surface()));
    return forBlocks(from.numberOfFaces(), inner, 0.3, 1., bounds, [&](int begin, int end) {
      Deviation deviation(to, reachable);
      DeviationBounds block;
      for (int f = begin; f < end; ++f)
      {
        const DeviationBounds own = deviation.of(from, f, start);
        block.lower = std::max(block.lower, own.lower);
        block.upper = std::max(block.upper, own.upper);
      }
      return block;
    });
  });
}

Status surfaceDeviation(const TriangleSurface& a, const TriangleSurface& b, double accuracy,
  const Progress& progress, DeviationBounds& bounds)
{
  const auto half = [&progress](double begin) -> Progress {
    return [&progress, begin](double x) { return report(progress, begin + 0.5 * x); };
  };
  const NearestTriangle nearestOfA(a);
  const NearestTriangle nearestOfB(b);
  Status status = oneSidedDeviation(a, nearestOfB, accuracy, half(0.), bounds);
  DeviationBounds back;
  if (status.ok())
  {
    status = oneSidedDeviation(b, nearestOfA, accuracy, half(0.5), back);
  }
  bounds.lower = std::max(bounds.lower, back.lower);
  bounds.upper = std::max(bounds.upper, back.upper);
  return status;
}
}
