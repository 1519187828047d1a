// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes.h"

#include "PolyDataConversion.h"

#include "vtkPolyData.h"

#include <cmath>
#include <map>
#include <numeric>

namespace shapes
{
using stipple::TriangleSurface;
using stipple::Vec3;

namespace
{
/// Merges points at the same place up to rounding, and connects.
TriangleSurface welded(const TriangleSurface& soup)
{
  TriangleSurface result;
  std::map<std::array<long, 3>, int> ids;
  std::vector<int> id;
  for (const Vec3& p : soup.points)
  {
    std::array<long, 3> key;
    for (int k = 0; k < 3; ++k)
    {
      key[k] = std::lround(p[k] * 1e9);
    }
    const auto [slot, fresh] = ids.try_emplace(key, static_cast<int>(result.points.size()));
    if (fresh)
    {
      result.points.push_back(p);
    }
    id.push_back(slot->second);
  }
  for (const stipple::Triangle& t : soup.triangles)
  {
    result.triangles.push_back({ id[t[0]], id[t[1]], id[t[2]] });
  }
  result.connect();
  return result;
}

void addGrid(TriangleSurface& s, const Vec3& origin, const Vec3& u, const Vec3& v, int n)
{
  const int base = static_cast<int>(s.points.size());
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      s.points.push_back(
        Vec3(origin + u * (static_cast<double>(i) / n) + v * (static_cast<double>(j) / n)));
    }
  }
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const int a = base + j * (n + 1) + i;
      s.triangles.push_back({ a, a + 1, a + n + 2 });
      s.triangles.push_back({ a, a + n + 2, a + n + 1 });
    }
  }
}
}

TriangleSurface torus(double ringRadius, double crossRadius, int nu, int nv)
{
  TriangleSurface s;
  for (int j = 0; j < nv; ++j)
  {
    for (int i = 0; i < nu; ++i)
    {
      const double u = 2 * stipple::Pi * i / nu;
      const double v = 2 * stipple::Pi * j / nv;
      const double r = ringRadius + crossRadius * std::cos(v);
      s.points.emplace_back(r * std::cos(u), r * std::sin(u), crossRadius * std::sin(v));
      const int a = j * nu + i;
      const int b = j * nu + (i + 1) % nu;
      const int c = ((j + 1) % nv) * nu + (i + 1) % nu;
      const int d = ((j + 1) % nv) * nu + i;
      s.triangles.push_back({ a, b, c });
      s.triangles.push_back({ a, c, d });
    }
  }
  s.connect();
  return s;
}

TriangleSurface sphere(double radius, int refinements)
{
  TriangleSurface s;
  const double g = (1 + std::sqrt(5.)) / 2;
  for (const auto& p : { Vec3(-1, g, 0), Vec3(1, g, 0), Vec3(-1, -g, 0), Vec3(1, -g, 0),
         Vec3(0, -1, g), Vec3(0, 1, g), Vec3(0, -1, -g), Vec3(0, 1, -g), Vec3(g, 0, -1),
         Vec3(g, 0, 1), Vec3(-g, 0, -1), Vec3(-g, 0, 1) })
  {
    s.points.push_back(p.normalized() * radius);
  }
  s.triangles = { { 0, 11, 5 }, { 0, 5, 1 }, { 0, 1, 7 }, { 0, 7, 10 }, { 0, 10, 11 }, { 1, 5, 9 },
    { 5, 11, 4 }, { 11, 10, 2 }, { 10, 7, 6 }, { 7, 1, 8 }, { 3, 9, 4 }, { 3, 4, 2 }, { 3, 2, 6 },
    { 3, 6, 8 }, { 3, 8, 9 }, { 4, 9, 5 }, { 2, 4, 11 }, { 6, 2, 10 }, { 8, 6, 7 }, { 9, 8, 1 } };
  for (int level = 0; level < refinements; ++level)
  {
    std::map<std::pair<int, int>, int> middle;
    const auto mid = [&](int a, int b) {
      const auto [slot, fresh] =
        middle.try_emplace(std::minmax(a, b), static_cast<int>(s.points.size()));
      if (fresh)
      {
        const Vec3 m = (s.points[a] + s.points[b]).normalized() * radius;
        s.points.push_back(m);
      }
      return slot->second;
    };
    std::vector<stipple::Triangle> finer;
    for (const stipple::Triangle& t : s.triangles)
    {
      const int a = mid(t[0], t[1]);
      const int b = mid(t[1], t[2]);
      const int c = mid(t[2], t[0]);
      finer.push_back({ t[0], a, c });
      finer.push_back({ t[1], b, a });
      finer.push_back({ t[2], c, b });
      finer.push_back({ a, b, c });
    }
    s.triangles = std::move(finer);
  }
  s.connect();
  return s;
}

TriangleSurface cube(int n)
{
  TriangleSurface s;
  const Vec3 x(1, 0, 0);
  const Vec3 y(0, 1, 0);
  const Vec3 z(0, 0, 1);
  addGrid(s, Vec3::Zero(), y, x, n);
  addGrid(s, z, x, y, n);
  addGrid(s, Vec3::Zero(), x, z, n);
  addGrid(s, y, z, x, n);
  addGrid(s, Vec3::Zero(), z, y, n);
  addGrid(s, x, y, z, n);
  return welded(s);
}

TriangleSurface cylinder(double radius, double height, int n, int m)
{
  TriangleSurface s;
  for (int j = 0; j <= m; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const double u = 2 * stipple::Pi * i / n;
      s.points.emplace_back(radius * std::cos(u), radius * std::sin(u), height * j / m);
    }
  }
  const int bottom = static_cast<int>(s.points.size());
  s.points.emplace_back(0, 0, 0);
  s.points.emplace_back(0, 0, height);
  for (int i = 0; i < n; ++i)
  {
    const int next = (i + 1) % n;
    for (int j = 0; j < m; ++j)
    {
      s.triangles.push_back({ j * n + i, j * n + next, (j + 1) * n + next });
      s.triangles.push_back({ j * n + i, (j + 1) * n + next, (j + 1) * n + i });
    }
    s.triangles.push_back({ next, i, bottom });
    s.triangles.push_back({ m * n + i, m * n + next, bottom + 1 });
  }
  s.connect();
  return s;
}

TriangleSurface cone(double radius, double height, int n, int m)
{
  TriangleSurface s;
  for (int j = 0; j < m; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const double u = 2 * stipple::Pi * i / n;
      const double r = radius * (m - j) / m;
      s.points.emplace_back(r * std::cos(u), r * std::sin(u), height * j / m);
    }
  }
  const int tip = static_cast<int>(s.points.size());
  s.points.emplace_back(0, 0, height);
  s.points.emplace_back(0, 0, 0);
  for (int i = 0; i < n; ++i)
  {
    const int next = (i + 1) % n;
    for (int j = 0; j + 1 < m; ++j)
    {
      s.triangles.push_back({ j * n + i, j * n + next, (j + 1) * n + next });
      s.triangles.push_back({ j * n + i, (j + 1) * n + next, (j + 1) * n + i });
    }
    s.triangles.push_back({ (m - 1) * n + i, (m - 1) * n + next, tip });
    s.triangles.push_back({ next, i, tip + 1 });
  }
  s.connect();
  return s;
}

TriangleSurface hornedSphere(int refinements)
{
  TriangleSurface s = sphere(1, refinements);
  for (Vec3& p : s.points)
  {
    const double away = 1 - p.x();
    p.x() += 2.5 * std::exp(-away / 0.03);
  }
  return s;
}

TriangleSurface perforatedSlab(int nx, int ny, int m)
{
  // Cubes of a layer, the odd ones of odd rows left out, on a lattice of m steps a cube.
  const auto isSolid = [&](int i, int j, int k) {
    return k == 0 && i >= 0 && j >= 0 && i <= 2 * nx && j <= 2 * ny && !(i % 2 == 1 && j % 2 == 1);
  };
  TriangleSurface s;
  std::map<std::array<int, 3>, int> ids;
  const auto pointAt = [&](const Eigen::Vector3i& p) {
    const auto [slot, fresh] =
      ids.try_emplace({ p.x(), p.y(), p.z() }, static_cast<int>(s.points.size()));
    if (fresh)
    {
      s.points.push_back(p.cast<double>() / m);
    }
    return slot->second;
  };
  for (int i = 0; i <= 2 * nx; ++i)
  {
    for (int j = 0; j <= 2 * ny; ++j)
    {
      for (int side = 0; side < 6 && isSolid(i, j, 0); ++side)
      {
        const int axis = side / 2;
        const Eigen::Vector3i normal = Eigen::Vector3i::Unit(axis) * (side % 2 ? 1 : -1);
        if (isSolid(i + normal.x(), j + normal.y(), normal.z()))
        {
          continue;
        }
        Eigen::Vector3i u = Eigen::Vector3i::Unit((axis + 1) % 3);
        Eigen::Vector3i v = Eigen::Vector3i::Unit((axis + 2) % 3);
        if (side % 2 == 0)
        {
          std::swap(u, v);
        }
        const Eigen::Vector3i origin =
          m * (Eigen::Vector3i(i, j, 0) + (side % 2 ? normal : Eigen::Vector3i(0, 0, 0)));
        for (int a = 0; a < m; ++a)
        {
          for (int b = 0; b < m; ++b)
          {
            const Eigen::Vector3i p = origin + a * u + b * v;
            const int p0 = pointAt(p);
            const int p1 = pointAt(p + u);
            const int p2 = pointAt(p + u + v);
            const int p3 = pointAt(p + v);
            s.triangles.push_back({ p0, p1, p2 });
            s.triangles.push_back({ p0, p2, p3 });
          }
        }
      }
    }
  }
  s.connect();
  return s;
}

TriangleSurface grid(int n, double height)
{
  TriangleSurface s;
  addGrid(s, Vec3(0, 0, height), Vec3(1, 0, 0), Vec3(0, 1, 0), n);
  return s;
}

TriangleSurface saddle(int n)
{
  TriangleSurface s;
  addGrid(s, Vec3(-1, -1, 0), Vec3(2, 0, 0), Vec3(0, 2, 0), n);
  for (Vec3& p : s.points)
  {
    p.z() = p.x() * p.y();
  }
  s.connect();
  return s;
}

stipple::CutSurface cutSurface(const TriangleSurface& surface)
{
  std::vector<int> source(surface.triangles.size());
  std::iota(source.begin(), source.end(), 0);
  return { surface, source };
}

vtkSmartPointer<vtkPolyData> toPolyData(const TriangleSurface& surface)
{
  return stipple::toPolyData(surface.points, surface.triangles);
}
}
