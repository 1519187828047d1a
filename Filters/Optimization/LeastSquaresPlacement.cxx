// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LeastSquaresPlacement.h"

#include "Relaxation.h"
#include "SurfaceError.h"
#include "Tuning.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>

namespace stipple
{
namespace
{
/// The triangle about v that is nearest to p, and the barycentric coordinates of p's projection in
/// it.
struct Foot
{
  std::array<Vertex, 3> corner;
  Vec3 bary = Vec3::Zero();
  Vec3 normal = Vec3::Zero();
};

Foot footOn(const OptimizedMesh& mesh, Vertex v, const Vec3& p)
{
  Foot best;
  double least = 1e300;
  mesh.forEachCorner(v, [&](Halfedge h) {
    const Vertex q = mesh.to(h);
    const Vertex r = mesh.apex(h);
    const Vec3& a = mesh.position(v);
    const Vec3& b = mesh.position(q);
    const Vec3& c = mesh.position(r);
    const Vec3 n = (b - a).cross(c - a);
    const double square = n.squaredNorm();
    if (square <= 0)
    {
      return;
    }
    const Vec3 bary = clampedBarycentric(barycentricInSpace(p, a, b, c));
    const double distance = (bary[0] * a + bary[1] * b + bary[2] * c - p).squaredNorm();
    if (distance < least)
    {
      least = distance;
      best = { { { v, q, r } }, bary, n / std::sqrt(square) };
    }
  });
  return best;
}

/// A third of the area of the faces about every point of the surface.
std::vector<double> areasOfPoints(const AtlasSurface& surface)
{
  std::vector<double> area(surface.points.size(), 0.);
  for (int f = 0; f < surface.numberOfFaces(); ++f)
  {
    for (int p : surface.triangles[f])
    {
      area[p] += surface.faceArea(f) / 3.;
    }
  }
  return area;
}
}

std::vector<Vec3> leastSquaresPositions(const OptimizedMesh& mesh)
{
  const AtlasSurface& surface = mesh.atlas().surface();
  const int n = mesh.vertices().size();
  const SurfaceError points(mesh);
  const std::vector<double> area = areasOfPoints(surface);
  // Unknown: the way of every vertex along its normal.
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  const double share = surface.area() / n;
  for (const Vertex v : mesh.vertices())
  {
    entries.emplace_back(v.index(), v.index(),
      share * (mesh.isFree(v) ? Tuning::PlacementInertia : Tuning::PlacementFixed));
    for (int p : points.pointsOf(v))
    {
      const Foot foot = footOn(mesh, v, surface.points[p]);
      if (!foot.corner[0].valid())
      {
        continue;
      }
      const double height = foot.normal.dot(surface.points[p] - mesh.position(v));
      Vec3 slope;
      for (int k = 0; k < 3; ++k)
      {
        slope[k] = foot.bary[k] * foot.normal.dot(mesh.normal(foot.corner[k]));
      }
      for (int k = 0; k < 3; ++k)
      {
        const int row = foot.corner[k].index();
        right[row] += area[p] * slope[k] * height;
        for (int l = 0; l < 3; ++l)
        {
          entries.emplace_back(row, foot.corner[l].index(), area[p] * slope[k] * slope[l]);
        }
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
  Eigen::VectorXd way = solver.solve(right);
  std::vector<Vec3> result(n);
  for (const Vertex v : mesh.vertices())
  {
    const double most = Tuning::FarthestPlacement * meanEdgeLength(mesh, v);
    const double w = way[v.index()];
    result[v.index()] = mesh.position(v) +
      (mesh.isFree(v) && std::isfinite(w) ? std::clamp(w, -most, most) : 0.) * mesh.normal(v);
  }
  // A triangle that would turn over takes its vertices back to the surface.
  for (bool changed = true; changed;)
  {
    changed = false;
    for (const Face f : mesh.faces())
    {
      const auto [a, b, c] = mesh.corners(f);
      const auto& r = result;
      const Vec3 before =
        (mesh.position(b) - mesh.position(a)).cross(mesh.position(c) - mesh.position(a));
      const Vec3 after = (r[b.index()] - r[a.index()]).cross(r[c.index()] - r[a.index()]);
      if (before.dot(after) <= Tuning::LeastTurnedCosine * before.norm() * after.norm())
      {
        for (const Vertex v : { a, b, c })
        {
          changed = changed || result[v.index()] != mesh.position(v);
          result[v.index()] = mesh.position(v);
        }
      }
    }
  }
  return result;
}
}
