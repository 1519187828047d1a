// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "VertexStar.h"

#include "Tuning.h"

#include <algorithm>
#include <cmath>

namespace stipple
{
namespace
{
/// A quality before the arc tangent is taken: of a sound triangle the sine and cosine of its
/// smallest angle, scaled alike.
struct Quality
{
  double folded = 0; ///< below zero: folded over
  double sine = 0;
  double cosine = 0;

  double value() const { return this->folded < 0 ? this->folded : std::atan2(sine, cosine); }
};

/// normal[i] is the surface's normal at the i-th corner, or zero; `normals` counts the others. If
/// there are none, onCreases is the triangle's agreement with the creases' sides.
Quality qualityOf(const Vec3& p, const Vec3& q, const Vec3& r,
  const std::array<const Vec3*, 3>& normal, int normals, double onCreases)
{
  const Vec3 u = q - p;
  const Vec3 w = r - q;
  const Vec3 z = p - r;
  const Vec3 n = z.cross(u);
  const double area = n.norm();
  const double uu = u.squaredNorm();
  const double ww = w.squaredNorm();
  const double zz = z.squaredNorm();
  if (!(area > Tuning::LeastArea * std::max({ uu, ww, zz })))
  {
    return { -2., 0., 0. }; // it has no side: as wrong as one that shows the other
  }
  const double d0 = n.dot(*normal[0]);
  const double d1 = n.dot(*normal[1]);
  const double d2 = n.dot(*normal[2]);
  // as OptimizedMesh has it
  const double agreement =
    normals == 0 ? onCreases : (area > 0 ? (d0 + d1 + d2) / (normals * area) : 1.);
  if (agreement < Tuning::LeastAgreement)
  {
    return { agreement - 1., 0., 0. };
  }
  // A vertex that has slipped out of its ring turns its back on some of its triangles, though these
  // may agree on average.
  const double worst = std::min({ d0, d1, d2 });
  if (worst < Tuning::LeastCosineAtVertex * area)
  {
    return { worst / area, 0., 0. };
  }
  // The smallest angle is opposite to the shortest edge.
  const double dot = uu <= ww && uu <= zz ? w.dot(z) : ww <= zz ? u.dot(z) : u.dot(w);
  return { 0., area, -dot };
}

const Vec3& normalOf(const OptimizedMesh& mesh, Vertex v)
{
  static const Vec3 None = Vec3::Zero();
  return mesh.isFree(v) ? mesh.normal(v) : None;
}

/// The sum of what is folded, else the least value.
class WorstQuality
{
public:
  void add(double quality)
  {
    this->Worst = std::min(this->Worst, quality);
    this->Folded += std::min(0., quality);
  }
  double value() const { return this->Folded < 0 ? this->Folded : this->Worst; }

private:
  double Worst = 10;
  double Folded = 0;
};
}

double triangleQuality(const OptimizedMesh& mesh, const TriangleCorners& corners)
{
  const Vertex a = mesh.from(corners[0]);
  const Vertex b = mesh.from(corners[1]);
  const Vertex c = mesh.from(corners[2]);
  const int normals = mesh.isFree(a) + mesh.isFree(b) + mesh.isFree(c);
  const Vec3& p = mesh.position(a);
  const Vec3& q = mesh.position(b);
  const Vec3& r = mesh.position(c);
  return qualityOf(p, q, r, { { &normalOf(mesh, a), &normalOf(mesh, b), &normalOf(mesh, c) } },
    normals, normals > 0 ? 1. : mesh.normalAgreementOnCreases(corners, (q - p).cross(r - p)))
    .value();
}

double faceQuality(const OptimizedMesh& mesh, Face f)
{
  return triangleQuality(mesh, mesh.triangleCorners(f));
}

double worstQuality(const OptimizedMesh& mesh, const std::vector<Face>& faces)
{
  double worst = 10;
  for (const Face f : faces)
  {
    worst = std::min(worst, faceQuality(mesh, f));
  }
  return worst;
}

double starQuality(const OptimizedMesh& mesh, Vertex v)
{
  WorstQuality worst;
  mesh.forEachFace(v, [&](Face f) { worst.add(faceQuality(mesh, f)); });
  return worst.value();
}

VertexStar::VertexStar(const OptimizedMesh& mesh, Vertex v)
  : Mesh(mesh)
  , V(v)
  , HasNormal(mesh.isFree(v))
{
  this->Triangles.reserve(8);
  mesh.forEachCorner(v, [&](Halfedge h) {
    const Vertex q = mesh.to(h);
    const Vertex r = mesh.apex(h);
    this->Triangles.push_back(
      { mesh.position(q), mesh.position(r), normalOf(mesh, q), normalOf(mesh, r),
        mesh.isFree(q) + mesh.isFree(r), { { h, mesh.next(h), mesh.previous(h) } } });
  });
}

double VertexStar::normalAgreementOnCreases(const Triangle& t, const SurfacePoint& there) const
{
  if (this->HasNormal || t.normals > 0)
  {
    return 1.;
  }
  const Vec3 normal = (t.q - there.position).cross(t.r - there.position);
  return this->Mesh.normalAgreementOnCreases(t.corners, normal);
}

template <typename Visit>
void VertexStar::forEachQuality(const SurfacePoint& there, const Visit& visit) const
{
  const Vec3 normal = this->HasNormal ? there.normal : Vec3(Vec3::Zero());
  for (const Triangle& t : this->Triangles)
  {
    visit(qualityOf(there.position, t.q, t.r, { { &normal, &t.normalQ, &t.normalR } },
      t.normals + this->HasNormal, this->normalAgreementOnCreases(t, there)));
  }
}

double VertexStar::quality(const SurfacePoint& there) const
{
  WorstQuality worst;
  this->forEachQuality(there, [&](const Quality& q) { worst.add(q.value()); });
  return worst.value();
}

double VertexStar::folds(const SurfacePoint& there) const
{
  double sum = 0;
  this->forEachQuality(there, [&](const Quality& q) { sum += std::min(0., q.folded); });
  return sum;
}

bool VertexStar::exceeds(const SurfacePoint& there, double bound) const
{
  if (bound < 0)
  {
    return this->folds(there) > bound &&
      std::none_of(this->Triangles.begin(), this->Triangles.end(),
        [&](const Triangle& t) { return t.q == there.position || t.r == there.position; });
  }
  const Vec3 normal = this->HasNormal ? there.normal : Vec3(Vec3::Zero());
  if (bound != this->Bound)
  {
    this->Bound = bound;
    this->SineOfBound = std::sin(bound);
    this->CosineOfBound = std::cos(bound);
  }
  const std::size_t n = this->Triangles.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    const std::size_t k = this->First + i < n ? this->First + i : this->First + i - n;
    const Triangle& t = this->Triangles[k];
    const Quality q = qualityOf(there.position, t.q, t.r, { { &normal, &t.normalQ, &t.normalR } },
      t.normals + this->HasNormal, this->normalAgreementOnCreases(t, there));
    if (q.folded < 0 || q.sine * this->CosineOfBound <= q.cosine * this->SineOfBound)
    {
      this->First = k;
      return false;
    }
  }
  return true;
}
}
