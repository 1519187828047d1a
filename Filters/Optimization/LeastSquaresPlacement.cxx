// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LeastSquaresPlacement.h"

#include "Relaxation.h"
#include "SurfaceError.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>

namespace stipple
{
namespace
{
using HalfedgeHandle = OptimizedMesh::Halfedge;

/// Weight of staying where a vertex is, over the area about it.
constexpr double Inertia = 0.01;
/// Farthest way along the normal over the mean length of the edges about a vertex.
constexpr double FarthestWay = 0.3;

/// The triangle about v that is nearest to p, and the barycentric coordinates of p's projection in
/// it.
struct Foot
{
  std::array<int, 3> corner = { { -1, -1, -1 } };
  Vec3 bary = Vec3::Zero();
  Vec3 normal = Vec3::Zero();
};

Foot footOn(const OptimizedMesh& mesh, int v, const Vec3& p)
{
  const auto& graph = mesh.graph();
  Foot best;
  double least = 1e300;
  mesh.forEachHalfedge(v, [&](HalfedgeHandle h) {
    const int q = graph.to_vertex_handle(h).idx();
    const int r = graph.to_vertex_handle(graph.next_halfedge_handle(h)).idx();
    const Vec3& a = mesh.position(v);
    const Vec3& b = mesh.position(q);
    const Vec3& c = mesh.position(r);
    const Vec3 n = (b - a).cross(c - a);
    const double square = n.squaredNorm();
    if (graph.is_boundary(h) || square <= 0)
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
  const int n = mesh.numberOfVertices();
  const SurfaceError points(mesh);
  const std::vector<double> area = areasOfPoints(surface);
  // Unknown: the way of every vertex along its normal.
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  const double share = surface.area() / n;
  for (int v = 0; v < n; ++v)
  {
    entries.emplace_back(v, v, mesh.freedom(v) == Freedom::Surface ? Inertia * share : 1e6 * share);
    for (int p : points.pointsOf(v))
    {
      const Foot foot = footOn(mesh, v, surface.points[p]);
      if (foot.corner[0] < 0)
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
        right[foot.corner[k]] += area[p] * slope[k] * height;
        for (int l = 0; l < 3; ++l)
        {
          entries.emplace_back(foot.corner[k], foot.corner[l], area[p] * slope[k] * slope[l]);
        }
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
  Eigen::VectorXd way = solver.solve(right);
  std::vector<Vec3> result(n);
  for (int v = 0; v < n; ++v)
  {
    const double most = FarthestWay * meanEdgeLength(mesh, v);
    way[v] = mesh.freedom(v) == Freedom::Surface && std::isfinite(way[v])
      ? std::clamp(way[v], -most, most)
      : 0.;
    result[v] = mesh.position(v) + way[v] * mesh.normal(v);
  }
  // A triangle that would turn over takes its vertices back to the surface.
  const std::vector<Triangle> triangles = mesh.triangles();
  for (bool changed = true; changed;)
  {
    changed = false;
    for (const Triangle& t : triangles)
    {
      const auto normalOf = [&](const auto& at) {
        return Vec3((at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0])));
      };
      const Vec3 before = normalOf([&](int v) { return mesh.position(v); });
      const Vec3 after = normalOf([&](int v) { return result[v]; });
      if (before.dot(after) <= 0.5 * before.norm() * after.norm())
      {
        for (int v : t)
        {
          changed = changed || result[v] != mesh.position(v);
          result[v] = mesh.position(v);
        }
      }
    }
  }
  return result;
}
}
