// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "NormalCurvature.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace stipple
{
namespace
{
using Tensor = Eigen::Matrix3d;

/// The corners about a point that are connected across edges that are not sharp.
struct Fan
{
  Vec3 normal = Vec3::Zero(); ///< unit length, or zero
  bool isClosed = false;      ///< all around the point
};

class Fans
{
public:
  explicit Fans(const CutSurface& surface)
    : Surface(surface)
    , OfCorner(surface.numberOfHalfedges(), -1)
  {
    for (const Halfedge h : surface.halfedges())
    {
      if (this->OfCorner[h] < 0)
      {
        this->add(h);
      }
    }
    this->mirrorNormals();
  }

  /// By the halfedge that leaves the corner.
  const Vec3& normal(Halfedge corner) const { return this->All[this->OfCorner[corner]].normal; }

private:
  bool isWall(Halfedge h) const { return this->Surface.isBoundary(h) || this->Surface.isCrease(h); }

  /// All corners of one fan, from the one beside its first wall on.
  void add(Halfedge corner)
  {
    const CutSurface& s = this->Surface;
    Fan fan;
    Halfedge first = corner;
    while (!this->isWall(first) && !fan.isClosed)
    {
      first = nextHalfedge(s.twin[first]);
      fan.isClosed = first == corner;
    }
    for (Halfedge h = first;;)
    {
      this->OfCorner[h] = static_cast<int>(this->All.size());
      const Halfedge in = previousHalfedge(h);
      const Vec3 a = s.edge(h);
      const Vec3 b = -s.edge(in);
      // Exact where the points lie on a sphere (N. Max, Weights for Computing Vertex Normals from
      // Facet Normals, 1999).
      const double weight = a.squaredNorm() * b.squaredNorm();
      fan.normal += weight > 0 ? Vec3(a.cross(b) / weight) : Vec3::Zero();
      h = s.twin[in];
      if (this->isWall(in) || h == first)
      {
        break;
      }
    }
    fan.normal.normalize();
    this->All.push_back(fan);
  }

  /// Where a fan ends, what is beyond is not known, and its normal leans inwards. The normals at
  /// the ends of an arc of a circle are mirror images of each other.
  void mirrorNormals()
  {
    const CutSurface& s = this->Surface;
    std::vector<Vec3> mirrored(this->All.size(), Vec3::Zero());
    for (const Halfedge h : s.halfedges())
    {
      const Fan& from = this->All[this->OfCorner[h]];
      const int to = this->OfCorner[nextHalfedge(h)];
      for (const bool forward : { true, false })
      {
        const Fan& inner = forward ? from : this->All[to];
        const int outer = forward ? to : this->OfCorner[h];
        if (inner.isClosed && !this->All[outer].isClosed)
        {
          const Vec3 d = s.edge(h).normalized();
          mirrored[outer] += inner.normal - 2. * inner.normal.dot(d) * d;
        }
      }
    }
    for (std::size_t i = 0; i < mirrored.size(); ++i)
    {
      if (mirrored[i].squaredNorm() > 0)
      {
        this->All[i].normal = mirrored[i].normalized();
      }
    }
  }

  const CutSurface& Surface;
  ElementArray<Halfedge, int> OfCorner;
  std::vector<Fan> All;
};

/// The derivative of the normals along a triangle, as a symmetric tensor in its plane.
Tensor tensorOf(const CutSurface& s, const Fans& fans, Face f)
{
  const Vec3 normal = s.faceNormal(f);
  const Vec3 u = s.edge(halfedgeOf(f, 0)).normalized();
  Eigen::Matrix<double, 3, 2> frame;
  frame << u, normal.cross(u);
  const auto inPlane = [&](const Vec3& a, const Vec3& b) {
    Eigen::Matrix2d columns;
    columns << frame.transpose() * a, frame.transpose() * b;
    return columns;
  };
  const Vec3& n = fans.normal(halfedgeOf(f, 0));
  const Eigen::Matrix2d edges = inPlane(s.edge(halfedgeOf(f, 0)), Vec3(-s.edge(halfedgeOf(f, 2))));
  const Eigen::Matrix2d turns =
    inPlane(fans.normal(halfedgeOf(f, 1)) - n, fans.normal(halfedgeOf(f, 2)) - n);
  const double area = edges.determinant();
  if (!(area > 0))
  {
    return Tensor::Zero();
  }
  const Eigen::Matrix2d derivative = turns * edges.inverse();
  return frame * (0.5 * (derivative + derivative.transpose())) * frame.transpose();
}
}

std::vector<double> largestNormalCurvature(const CutSurface& surface)
{
  const Fans fans(surface);
  ElementArray<Face, Tensor> tensor(surface.triangles.size());
  for (const Face f : surface.faces())
  {
    tensor[f] = tensorOf(surface, fans, f);
  }
  std::vector<double> result;
  result.reserve(surface.triangles.size());
  for (const Face f : surface.faces())
  {
    const double area = surface.faceArea(f);
    const Vec3 normal = surface.faceNormal(f);
    Tensor sum = area * tensor[f];
    double weights = area;
    for (const Halfedge h : halfedgesOf(f))
    {
      if (surface.isBoundary(h) || surface.isCrease(h))
      {
        continue;
      }
      const Face g = faceOf(surface.twin[h]);
      // A large flat neighbour does not make a narrow round strip flat.
      const double weight = std::min(area, surface.faceArea(g));
      const Tensor turn =
        Eigen::Quaterniond::FromTwoVectors(surface.faceNormal(g), normal).toRotationMatrix();
      sum += weight * (turn * tensor[g] * turn.transpose());
      weights += weight;
    }
    const Eigen::SelfAdjointEigenSolver<Tensor> solver(
      Tensor(sum / weights), Eigen::EigenvaluesOnly);
    const double largest = solver.eigenvalues().cwiseAbs().maxCoeff();
    result.push_back(weights > 0 && std::isfinite(largest) ? largest : 0.);
  }
  return result;
}
}
