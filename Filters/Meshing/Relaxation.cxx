// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Relaxation.h"

#include <algorithm>
#include <cmath>

namespace stipple
{
namespace
{
using Halfedge = OptimizedMesh::Halfedge;

/// Calls visit(q, r) for every triangle (v, q, r) about v.
template <typename Visit>
void forEachTriangle(const OptimizedMesh& mesh, int v, const Visit& visit)
{
  const auto& graph = mesh.graph();
  const Halfedge first = graph.halfedge_handle(OptimizedMesh::Vertex(v));
  Halfedge h = first;
  do
  {
    const Halfedge g = graph.next_halfedge_handle(h);
    if (!graph.is_boundary(h))
    {
      visit(graph.to_vertex_handle(h).idx(), graph.to_vertex_handle(g).idx());
    }
    h = graph.opposite_halfedge_handle(graph.next_halfedge_handle(g));
  } while (h != first);
}
}

Vec3 lloydStep(const OptimizedMesh& mesh, int v)
{
  const Vec3& x = mesh.position(v);
  const bool uniform = mesh.uniform();
  const double here = mesh.density(v) * mesh.density(v);
  Vec3 moment = Vec3::Zero();
  double mass = 0;
  Vec3 fallbackMoment = Vec3::Zero();
  double fallbackMass = 0;
  forEachTriangle(mesh, v, [&](int q, int r) {
    const Vec3 a = mesh.position(q) - x;
    const Vec3 b = mesh.position(r) - x;
    const double aa = a.squaredNorm();
    const double bb = b.squaredNorm();
    const double ab = a.dot(b);
    const double square = aa * bb - ab * ab;
    if (square <= 0)
    {
      return;
    }
    const double twiceArea = std::sqrt(square);
    // The circumcentre is s a + t b. The cell's part in this triangle is (0, a/2, c) and (0, c, b/2).
    const double s = 0.5 * bb * (aa - ab) / square;
    const double t = 0.5 * aa * (bb - ab) / square;
    double first = 0.25 * t * twiceArea;
    double second = 0.25 * s * twiceArea;
    double whole = 0.5 * twiceArea;
    if (!uniform)
    {
      // Linear over the triangle, taken at the centroids of the parts.
      const double atA = mesh.density(q) * mesh.density(q) - here;
      const double atB = mesh.density(r) * mesh.density(r) - here;
      const double low = 0.1 * std::min({ here, here + atA, here + atB });
      first *= std::max(low, here + ((0.5 + s) * atA + t * atB) / 3.);
      second *= std::max(low, here + (s * atA + (0.5 + t) * atB) / 3.);
      whole *= here + (atA + atB) / 3.;
    }
    moment += (first * (0.5 + s) + second * s) / 3. * a + (first * t + second * (0.5 + t)) / 3. * b;
    mass += first + second;
    fallbackMoment += whole / 3. * (a + b);
    fallbackMass += whole;
  });
  // In a ring that is not Delaunay the pieces may overlap until little is left: then the ring's own centroid.
  if (mass > 0.1 * fallbackMass)
  {
    return moment / mass;
  }
  return fallbackMass > 0 ? Vec3(fallbackMoment / fallbackMass) : Vec3::Zero();
}

Vec3 laplacianStep(const OptimizedMesh& mesh, int v, bool weightedByDensity)
{
  const Vec3& x = mesh.position(v);
  Vec3 sum = Vec3::Zero();
  double total = 0;
  forEachTriangle(mesh, v, [&](int q, int r) {
    const Vec3& a = mesh.position(q);
    const Vec3& b = mesh.position(r);
    double area = triangleArea(x, a, b);
    if (weightedByDensity)
    {
      area *= (mesh.density(v) + mesh.density(q) + mesh.density(r)) / 3.;
    }
    // The angle at q is opposite to the edge from v to r, and the other way round.
    sum += area * (std::max(0., cotangent(a, b, x, 10.)) * (b - x) + std::max(0., cotangent(b, x, a, 10.)) * (a - x));
    total += area;
  });
  return total > 0 ? Vec3(sum / total) : Vec3::Zero();
}

void relaxBackbones(const OptimizedMesh& mesh, std::vector<double>& arcLength)
{
  const auto& chains = mesh.chains();
  for (std::size_t c = 0; c < chains.size(); ++c)
  {
    const std::vector<int>& chain = chains[c];
    const int n = static_cast<int>(chain.size());
    if (n < 3)
    {
      continue;
    }
    const BackboneTrace& trace = mesh.atlas().traces()[c];
    const bool closed = mesh.atlas().graph().backbones[c].closed;
    // Positions along the backbone, ascending; those of a cycle go on past its end.
    std::vector<double> s(n);
    for (int i = 0; i < n; ++i)
    {
      s[i] = mesh.arcLength(chain[i]);
      if (!closed)
      {
        s[i] = i == 0 ? 0. : i == n - 1 ? trace.length() : s[i];
      }
      while (closed && i > 0 && s[i] <= s[i - 1])
      {
        s[i] += trace.length();
      }
    }
    // The wanted number of vertices up to every one: spacing goes with the root of the density.
    std::vector<double> count(n, 0.);
    for (int i = 1; i < n; ++i)
    {
      count[i] = count[i - 1] +
        (s[i] - s[i - 1]) * 0.5 * (std::sqrt(mesh.density(chain[i - 1])) + std::sqrt(mesh.density(chain[i])));
    }
    double shift = 0; // of a cycle as a whole: none on average
    const auto wanted = [&](int i) {
      const double c = count[n - 1] * i / (n - 1);
      const auto above = std::upper_bound(count.begin() + 1, count.end() - 1, c);
      const int k = static_cast<int>(above - count.begin());
      const double width = count[k] - count[k - 1];
      return s[k - 1] + (width > 0 ? (c - count[k - 1]) / width : 0.) * (s[k] - s[k - 1]);
    };
    if (closed)
    {
      for (int i = 0; i + 1 < n; ++i)
      {
        shift += (s[i] - wanted(i)) / (n - 1);
      }
    }
    for (int i = closed ? 0 : 1; i + 1 < n; ++i)
    {
      const int v = chain[i];
      if (mesh.freedom(v) != Freedom::Backbone)
      {
        continue;
      }
      const double before = i > 0 ? s[i] - s[i - 1] : s[n - 1] - s[n - 2];
      const double after = s[i + 1] - s[i];
      arcLength[v] =
        mesh.arcLength(v) + std::clamp(wanted(i) + shift - s[i], -0.4 * before, 0.4 * after);
    }
  }
}
}
