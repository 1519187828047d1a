// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "VertexStar.h"

#include <algorithm>
#include <cmath>

namespace stipple
{
namespace
{
/// A vertex and a triangle whose normals' cosine is below this face away from each other.
constexpr double WorstCosine = -0.3;

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
  const double d0 = n.dot(*normal[0]);
  const double d1 = n.dot(*normal[1]);
  const double d2 = n.dot(*normal[2]);
  // as OptimizedMesh has it
  const double agreement =
    normals == 0 ? onCreases : (area > 0 ? (d0 + d1 + d2) / (normals * area) : 1.);
  if (agreement < OptimizedMesh::minimumAgreement())
  {
    return { agreement - 1., 0., 0. };
  }
  // A vertex that has slipped out of its ring turns its back on some of its triangles, though these
  // may agree on average.
  const double worst = std::min({ d0, d1, d2 });
  if (worst < WorstCosine * area)
  {
    return { worst / area, 0., 0. };
  }
  // The smallest angle is opposite to the shortest edge.
  const double uu = u.squaredNorm();
  const double ww = w.squaredNorm();
  const double zz = z.squaredNorm();
  const double dot = uu <= ww && uu <= zz ? w.dot(z) : ww <= zz ? u.dot(z) : u.dot(w);
  return { 0., area, -dot };
}

const Vec3& normalOf(const OptimizedMesh& mesh, int v)
{
  static const Vec3 None = Vec3::Zero();
  return mesh.freedom(v) == Freedom::Surface ? mesh.normal(v) : None;
}

bool hasNormal(const OptimizedMesh& mesh, int v)
{
  return mesh.freedom(v) == Freedom::Surface;
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

double triangleQuality(const OptimizedMesh& mesh, int a, int b, int c)
{
  const int normals = hasNormal(mesh, a) + hasNormal(mesh, b) + hasNormal(mesh, c);
  const Vec3& p = mesh.position(a);
  const Vec3& q = mesh.position(b);
  const Vec3& r = mesh.position(c);
  return qualityOf(p, q, r, { { &normalOf(mesh, a), &normalOf(mesh, b), &normalOf(mesh, c) } },
    normals, normals > 0 ? 1. : mesh.agreementOnCreases(a, b, c, (q - p).cross(r - p)))
    .value();
}

double faceQuality(const OptimizedMesh& mesh, int face)
{
  const auto t = mesh.corners(face);
  return triangleQuality(mesh, t[0], t[1], t[2]);
}

double starQuality(const OptimizedMesh& mesh, int v)
{
  WorstQuality worst;
  mesh.forEachFace(v, [&](int f) { worst.add(faceQuality(mesh, f)); });
  return worst.value();
}

VertexStar::VertexStar(const OptimizedMesh& mesh, int v)
  : Mesh(mesh)
  , V(v)
  , HasNormal(hasNormal(mesh, v))
{
  this->Triangles.reserve(8);
  mesh.forEachFace(v, [&](int f) {
    auto t = mesh.corners(f);
    std::rotate(t.begin(), std::find(t.begin(), t.end(), v), t.end());
    this->Triangles.push_back({ mesh.position(t[1]), mesh.position(t[2]), normalOf(mesh, t[1]),
      normalOf(mesh, t[2]), hasNormal(mesh, t[1]) + hasNormal(mesh, t[2]), { { t[1], t[2] } } });
  });
}

double VertexStar::agreementOnCreases(const Triangle& t, const Footing& there) const
{
  if (this->HasNormal || t.normals > 0)
  {
    return 1.;
  }
  const Vec3 normal = (t.q - there.position).cross(t.r - there.position);
  return this->Mesh.agreementOnCreases(this->V, t.ends[0], t.ends[1], normal);
}

double VertexStar::quality(const Footing& there) const
{
  const Vec3 normal = this->HasNormal ? there.normal : Vec3(Vec3::Zero());
  WorstQuality worst;
  for (const Triangle& t : this->Triangles)
  {
    worst.add(qualityOf(there.position, t.q, t.r, { { &normal, &t.normalQ, &t.normalR } },
      t.normals + this->HasNormal, this->agreementOnCreases(t, there))
                .value());
  }
  return worst.value();
}

bool VertexStar::exceeds(const Footing& there, double bound) const
{
  if (bound < 0)
  {
    return this->quality(there) > bound;
  }
  const Vec3 normal = this->HasNormal ? there.normal : Vec3(Vec3::Zero());
  const double sine = std::sin(bound);
  const double cosine = std::cos(bound);
  const std::size_t n = this->Triangles.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    const std::size_t k = this->First + i < n ? this->First + i : this->First + i - n;
    const Triangle& t = this->Triangles[k];
    const Quality q = qualityOf(there.position, t.q, t.r, { { &normal, &t.normalQ, &t.normalR } },
      t.normals + this->HasNormal, this->agreementOnCreases(t, there));
    if (q.folded < 0 || q.sine * cosine <= q.cosine * sine)
    {
      this->First = k;
      return false;
    }
  }
  return true;
}
}
