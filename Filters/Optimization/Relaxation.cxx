// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Relaxation.h"

#include "ParallelFor.h"
#include "Tuning.h"

#include <algorithm>
#include <cmath>

namespace stipple
{
namespace
{
/// Calls visit(h) for every triangle about v, counterclockwise, with its halfedge out of v.
template <typename Visit>
void forEachTriangle(const OptimizedMesh& mesh, Vertex v, const Visit& visit)
{
  const Halfedge first = mesh.halfedge(v);
  Halfedge h = first;
  do
  {
    if (!mesh.isBoundary(h))
    {
      visit(h);
    }
    h = mesh.opposite(mesh.previous(h));
  } while (h != first);
}

/// Mass and first moment of a density that is linear over a triangle (x, x + a, x + b).
struct CellIntegral
{
  double mass = 0;
  double alongA = 0; ///< moment, in units of a
  double alongB = 0;

  /// Adds the triangle between x and the points given by their coordinates along a and b.
  void add(
    const Vec2& p, const Vec2& q, double twiceArea, double here, double slopeA, double slopeB)
  {
    const Vec2 centroid = (p + q) / 3.;
    const double low =
      Tuning::LeastDensityInCell * std::min({ here, here + slopeA, here + slopeB });
    const double density = std::max(low, here + slopeA * centroid.x() + slopeB * centroid.y());
    const double m = 0.5 * cross2(p, q) * twiceArea * density;
    this->mass += m;
    this->alongA += m * centroid.x();
    this->alongB += m * centroid.y();
  }
};

/// A vector of a triangle's plane, turned with it into the tangent plane at v. A triangle that cuts
/// off a tip is steep there: projected, a step across it would lead nowhere; turned, it leads up to
/// the tip. On a crease there is no tangent plane, and what counts of a step is along the crease.
inline Vec3 turned(
  const OptimizedMesh& mesh, Vertex v, const Vec3& vector, const Vec3& triangleNormal)
{
  if (!mesh.isFree(v))
  {
    return vector;
  }
  const Vec3& normal = mesh.normal(v);
  // In a fold, no way of turning is better than another.
  const double scale = 1. / std::max(Tuning::LeastTurn, 1. + triangleNormal.dot(normal));
  return vector - normal.dot(vector) * scale * (triangleNormal + normal);
}

/// Area of the surface under a triangle over the triangle's own, estimated from the normals at its
/// vertices.
double areaOfSurface(double normalAgreement)
{
  return 1. / std::clamp(normalAgreement, 1. / Tuning::MostHiddenArea, 1.);
}

/// A triangle (v, q, r) about v.
struct Corner
{
  Vec3 a; ///< from v to q
  Vec3 b; ///< from v to r
  const FaceMeasure* face = nullptr;
  double slopeA = 0; ///< how the weight changes from v to q
  double slopeB = 0; ///< and to r

  double mass(double here) const
  {
    return 0.5 * this->face->twiceArea * (here + (this->slopeA + this->slopeB) / 3.);
  }
};

/// Calls visit(corner, wall) for every triangle about v that is not degenerate; wall: the edge
/// opposite to v is a crease, or bounds the surface.
template <typename Measure, typename Visit>
void forEachCorner(
  const OptimizedMesh& mesh, const Measure& measureOf, Vertex v, double here, const Visit& visit)
{
  const Vec3& x = mesh.position(v);
  forEachTriangle(mesh, v, [&](Halfedge h) {
    const Vertex q = mesh.to(h);
    const Vertex r = mesh.apex(h);
    const FaceMeasure& face = measureOf(mesh.face(h));
    if (face.twiceArea > 0)
    {
      Corner c;
      c.face = &face;
      c.a = mesh.position(q) - x;
      c.b = mesh.position(r) - x;
      c.slopeA = mesh.density(q) * mesh.density(q) - here;
      c.slopeB = mesh.density(r) * mesh.density(r) - here;
      visit(c, mesh.isCrease(mesh.edge(mesh.next(h))));
    }
  });
}

/// To the centroid of the triangles about v.
template <typename Measure>
Vec3 stepToCentroidOfRing(
  const OptimizedMesh& mesh, const Measure& measureOf, Vertex v, double here, double mass)
{
  Vec3 moment = Vec3::Zero();
  forEachCorner(mesh, measureOf, v, here, [&](const Corner& c, bool) {
    moment += turned(mesh, v, c.mass(here) / 3. * (c.a + c.b), c.face->normal);
  });
  return moment / mass;
}

FaceMeasure measureFace(const OptimizedMesh& mesh, Face f)
{
  const auto [a, b, c] = mesh.corners(f);
  const Vec3& x = mesh.position(a);
  const Vec3 cross = (mesh.position(b) - x).cross(mesh.position(c) - x);
  FaceMeasure result;
  result.square = cross.squaredNorm();
  if (result.square > 0)
  {
    const double flatArea = std::sqrt(result.square);
    result.normal = cross / flatArea;
    // The area of the surface under the triangle, not of the triangle: else tips and ridges that a
    // triangle cuts off would have no weight, and vertices would slide off them.
    result.twiceArea = flatArea * areaOfSurface(mesh.normalAgreement(a, b, c, cross, flatArea));
  }
  return result;
}

template <typename Measure>
Vec3 lloydStepWith(const OptimizedMesh& mesh, const Measure& measureOf, Vertex v, bool isDelaunay)
{
  // Points settle with a density that is the root of the weight of a centroidal Voronoi
  // tessellation in the plane.
  const double here = mesh.density(v) * mesh.density(v);
  Vec3 moment = Vec3::Zero();
  double mass = 0;
  double massOfRing = 0;
  forEachCorner(mesh, measureOf, v, here, [&](const Corner& c, bool wall) {
    const Vec2 halfA(0.5, 0.);
    const Vec2 halfB(0., 0.5);
    const double aa = c.a.squaredNorm();
    const double bb = c.b.squaredNorm();
    const double ab = c.a.dot(c.b);
    const double area = c.face->twiceArea;
    CellIntegral cell;
    if ((wall || !isDelaunay) && ab < 0)
    {
      // The circumcentre lies beyond the wall: the cell ends there.
      const double atA = 0.5 * aa / (aa - ab);
      const double atB = 0.5 * bb / (bb - ab);
      const Vec2 p(1. - atA, atA);
      const Vec2 q(atB, 1. - atB);
      cell.add(halfA, p, area, here, c.slopeA, c.slopeB);
      cell.add(p, q, area, here, c.slopeA, c.slopeB);
      cell.add(q, halfB, area, here, c.slopeA, c.slopeB);
    }
    else
    {
      const double scale = 0.5 / c.face->square;
      const Vec2 circumcentre(scale * bb * (aa - ab), scale * aa * (bb - ab));
      cell.add(halfA, circumcentre, area, here, c.slopeA, c.slopeB);
      cell.add(circumcentre, halfB, area, here, c.slopeA, c.slopeB);
    }
    moment += turned(mesh, v, cell.alongA * c.a + cell.alongB * c.b, c.face->normal);
    mass += cell.mass;
    massOfRing += c.mass(here);
  });
  // In a ring that is not Delaunay the pieces may overlap until little is left: then the ring's own
  // centroid.
  if (mass > Tuning::LeastMassOfCell * massOfRing)
  {
    return moment / mass;
  }
  return massOfRing > 0 ? stepToCentroidOfRing(mesh, measureOf, v, here, massOfRing)
                        : Vec3(Vec3::Zero());
}
}

void FaceMeasures::update(const OptimizedMesh& mesh)
{
  this->Measures.resize(static_cast<std::size_t>(mesh.faces().size()));
  parallelFor(mesh.faces(), [&](Face f) { this->Measures[f] = measureFace(mesh, f); });
}

Vec3 lloydStep(const OptimizedMesh& mesh, const FaceMeasures& measures, Vertex v, bool isDelaunay)
{
  const auto measureOf = [&](Face f) -> const FaceMeasure& { return measures[f]; };
  return lloydStepWith(mesh, measureOf, v, isDelaunay);
}

Vec3 lloydStep(const OptimizedMesh& mesh, Vertex v)
{
  const auto measureOf = [&](Face f) { return measureFace(mesh, f); };
  return lloydStepWith(mesh, measureOf, v, true);
}

Vec3 laplacianStep(const OptimizedMesh& mesh, Vertex v, bool weightedByDensity)
{
  const Vec3& x = mesh.position(v);
  Vec3 sum = Vec3::Zero();
  double total = 0;
  forEachTriangle(mesh, v, [&](Halfedge h) {
    const Vertex q = mesh.to(h);
    const Vertex r = mesh.apex(h);
    const Vec3& a = mesh.position(q);
    const Vec3& b = mesh.position(r);
    double area = triangleArea(x, a, b);
    if (weightedByDensity)
    {
      area *= (mesh.density(v) + mesh.density(q) + mesh.density(r)) / 3.;
    }
    // The angle at q is opposite to the edge from v to r, and the other way round.
    sum += area *
      (std::max(0., cotangent(a, b, x, Tuning::LargestCotangent)) * (b - x) +
        std::max(0., cotangent(b, x, a, Tuning::LargestCotangent)) * (a - x));
    total += area;
  });
  return total > 0 ? Vec3(sum / total) : Vec3::Zero();
}

Vec3 stepToMiddle(const OptimizedMesh& mesh, Vertex v)
{
  Vec3 sum = Vec3::Zero();
  int count = 0;
  mesh.forEachNeighbour(v, [&](Vertex u) {
    sum += mesh.position(u);
    ++count;
  });
  return sum / count - mesh.position(v);
}

Vec3 towardsRidges(const OptimizedMesh& mesh, Vertex v, const Vec3& step)
{
  // Minimises inertia |d - step|^2 + sum of w |distance of x + d to the tangent plane at a
  // neighbour|^2 over d in the tangent plane at v. Planes that are nearly parallel to it say
  // nothing about where a ridge is.
  constexpr double Ridge = Tuning::RidgeCosine;
  const Vec3& x = mesh.position(v);
  const Vec3& normal = mesh.normal(v);
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Vec3 right = Vec3::Zero();
  bool onRidge = false;
  forEachTriangle(mesh, v, [&](Halfedge h) {
    const Vertex q = mesh.to(h);
    const Vec3& n = mesh.normal(q);
    const double bend = Ridge - n.dot(normal);
    if (bend > 0 && mesh.isFree(q))
    {
      onRidge = true;
      const double w = std::min(bend / Ridge, 1.);
      matrix += w * n * n.transpose();
      right += w * n * n.dot(mesh.position(q) - x);
    }
  });
  if (!onRidge)
  {
    return step;
  }
  matrix += Tuning::RidgeInertia * Eigen::Matrix3d::Identity() +
    Tuning::RidgeFlatness * normal * normal.transpose();
  right += Tuning::RidgeInertia * step;
  return matrix.ldlt().solve(right);
}

bool exceedsEdges(const OptimizedMesh& mesh, Vertex v, double length, double share)
{
  // The shortest edge is no longer than the mean, and costs no roots.
  double shortest = 1e300;
  mesh.forEachHalfedge(v, [&](Halfedge h) {
    shortest = std::min(shortest, (mesh.position(mesh.to(h)) - mesh.position(v)).squaredNorm());
  });
  return length * length > share * share * shortest && length > share * meanEdgeLength(mesh, v);
}

VertexSpacing::VertexSpacing(const OptimizedMesh& mesh)
  : Mesh(mesh)
  , Visible(Tuning::VisibleDistance * mesh.atlas().surface().boundingBoxDiagonal())
{
  double total = 0;
  for (const Face f : mesh.faces())
  {
    const auto [a, b, c] = mesh.corners(f);
    total += mesh.faceArea(f) * (mesh.density(a) + mesh.density(b) + mesh.density(c)) / 3.;
  }
  this->AtUnitDensity = std::sqrt(2. / std::sqrt(3.) * total / mesh.vertices().size());
}

double meanEdgeLength(const OptimizedMesh& mesh, Vertex v)
{
  double sum = 0;
  int count = 0;
  forEachTriangle(mesh, v, [&](Halfedge h) {
    sum += (mesh.position(mesh.to(h)) - mesh.position(v)).norm();
    ++count;
  });
  return sum / count;
}

namespace
{
/// Whether the Voronoi cell of a vertex on a crease is cut off by a crease in a triangle about it,
/// this one or another: then vertices that no edge joins to it may have a share in it, and it is
/// not to be had from these triangles.
bool isInNarrowPart(const OptimizedMesh& mesh, Vertex v)
{
  bool narrow = false;
  const auto isObtuse = [](const Vec3& p, const Vec3& q) {
    return p.dot(q) < -Tuning::RoundingOfAngle * p.norm() * q.norm();
  };
  forEachTriangle(mesh, v, [&](Halfedge h) {
    const Vec3 a = mesh.position(mesh.to(h)) - mesh.position(v);
    const Vec3 b = mesh.position(mesh.apex(h)) - mesh.position(v);
    narrow = narrow || (mesh.isCrease(mesh.edge(mesh.next(h))) && isObtuse(a, b)) ||
      (mesh.isCrease(mesh.edge(h)) && isObtuse(-b, a - b)) ||
      (mesh.isCrease(mesh.edge(mesh.previous(h))) && isObtuse(-a, b - a));
  });
  return narrow;
}

/// A run of points along a backbone, with their positions on it, ascending.
struct BackboneRun
{
  std::vector<Vertex> vertices;
  std::vector<double> s;
};

/// Moves the points inside a run to where the density wants them, its ends staying; or all of a
/// cycle, whose last point is its first.
void relaxRun(const OptimizedMesh& mesh, const BackboneRun& run, bool cycle,
  ElementArray<Vertex, double>& arcLength)
{
  const std::vector<double>& s = run.s;
  const int n = static_cast<int>(s.size());
  if (n < 3)
  {
    return;
  }
  // The wanted number of vertices up to every one: spacing goes with the root of the density.
  std::vector<double> count(n, 0.);
  for (int i = 1; i < n; ++i)
  {
    count[i] = count[i - 1] +
      (s[i] - s[i - 1]) * 0.5 *
        (std::sqrt(mesh.density(run.vertices[i - 1])) + std::sqrt(mesh.density(run.vertices[i])));
  }
  double shift = 0; // of a cycle as a whole: none on average
  const auto wanted = [&](int i) {
    const double c = count[n - 1] * i / (n - 1);
    const auto above = std::upper_bound(count.begin() + 1, count.end() - 1, c);
    const int k = static_cast<int>(above - count.begin());
    const double width = count[k] - count[k - 1];
    return s[k - 1] + (width > 0 ? (c - count[k - 1]) / width : 0.) * (s[k] - s[k - 1]);
  };
  if (cycle)
  {
    for (int i = 0; i + 1 < n; ++i)
    {
      shift += (s[i] - wanted(i)) / (n - 1);
    }
  }
  for (int i = cycle ? 0 : 1; i + 1 < n; ++i)
  {
    const Vertex v = run.vertices[i];
    if (mesh.freedom(v) != Freedom::Backbone)
    {
      continue;
    }
    const double before = i > 0 ? s[i] - s[i - 1] : s[n - 1] - s[n - 2];
    const double after = s[i + 1] - s[i];
    arcLength[v] = mesh.arcLength(v) +
      std::clamp(
        wanted(i) + shift - s[i], -Tuning::LongestSlide * before, Tuning::LongestSlide * after);
  }
}
}

void relaxBackbones(const OptimizedMesh& mesh, const std::vector<char>& which,
  ElementArray<Vertex, double>& arcLength)
{
  for (std::size_t c = 0; c < mesh.chains().size(); ++c)
  {
    OptimizedMesh::Chain chain = mesh.chains()[c];
    const int n = static_cast<int>(chain.size());
    if (n < 3 || which[c] == 0)
    {
      continue;
    }
    const double length = mesh.atlas().traces()[c].length();
    const bool closed = mesh.atlas().graph().backbones[c].closed;
    const auto isFixed = [&](int i) { return mesh.freedom(chain[i].vertex) == Freedom::None; };
    if (closed)
    {
      // A constraint holds a cycle: it begins and ends there.
      int first = 0;
      while (first + 1 < n && !isFixed(first))
      {
        ++first;
      }
      first = first + 1 < n ? first : 0;
      std::rotate(chain.begin(), chain.begin() + first, chain.end() - 1);
      chain.back() = chain.front();
    }
    BackboneRun all;
    for (int i = 0; i < n; ++i)
    {
      all.vertices.push_back(chain[i].vertex);
      all.s.push_back(mesh.arcLength(chain[i]));
      while (closed && i > 0 && all.s[i] <= all.s[i - 1])
      {
        all.s[i] += length;
      }
    }
    if (closed && !isFixed(0))
    {
      relaxRun(mesh, all, true, arcLength);
      continue;
    }
    for (int begin = 0, i = 1; i < n; ++i)
    {
      if (i + 1 == n || isFixed(i))
      {
        relaxRun(mesh,
          { { all.vertices.begin() + begin, all.vertices.begin() + i + 1 },
            { all.s.begin() + begin, all.s.begin() + i + 1 } },
          false, arcLength);
        begin = i;
      }
    }
  }
}

double lloydSlide(const OptimizedMesh& mesh, const FaceMeasures& measures, Vertex v)
{
  // To its neighbours on the backbone, in space and along it: where features were simplified, a
  // neighbour may lie off the backbone, farther away than its place on it.
  Vec3 before = Vec3::Zero();
  Vec3 after = Vec3::Zero();
  double arcBefore = 0;
  double arcAfter = 0;
  const int backbone = mesh.backbone(v);
  const bool closed = mesh.atlas().graph().backbones[backbone].closed;
  const double length = mesh.atlas().traces()[backbone].length();
  mesh.forEachHalfedge(v, [&](Halfedge h) {
    if (mesh.isCrease(mesh.edge(h)))
    {
      const Crease& crease = mesh.crease(mesh.edge(h));
      const bool leaves = crease.from.vertex == v;
      const double arc = mesh.arcLength(crease.to) - mesh.arcLength(crease.from);
      (leaves ? after : before) = mesh.position(mesh.to(h)) - mesh.position(v);
      (leaves ? arcAfter : arcBefore) = std::max(0., closed && arc <= 0 ? arc + length : arc);
    }
  });
  const Vec3 step =
    isInNarrowPart(mesh, v) ? stepToMiddle(mesh, v) : lloydStep(mesh, measures, v, true);
  const double slide = std::clamp(step.dot((after - before).normalized()),
    -Tuning::LongestSlide * before.norm(), Tuning::LongestSlide * after.norm());
  if (before == Vec3::Zero() || after == Vec3::Zero())
  {
    return slide; // the last one on it
  }
  const double nearest = 0.5 * Tuning::NearestOnBackbone * (arcBefore + arcAfter);
  return std::clamp(slide, nearest - arcBefore, arcAfter - nearest);
}
}
