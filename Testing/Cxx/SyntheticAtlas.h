// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Charts, feature graphs and samples made by hand, so that the mesher is tested without atlas and
// sampler.
#ifndef stipple_testing_SyntheticAtlas_h
#define stipple_testing_SyntheticAtlas_h

#include "ChartGraph.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include "PolyDataConversion.h"

#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <tuple>

namespace synthetic
{
using namespace stipple;

struct MadeAtlas
{
  vtkNew<vtkPartitionedDataSetCollection> charts;
  FeatureGraph graph;
  vtkSmartPointer<vtkPolyData> graphData;
  AtlasSurface surface;
  std::vector<BackboneTrace> traces;
};

/// Puts charts together; points of equal position are one surface point.
class Builder
{
public:
  int pointAt(const Vec3& p)
  {
    const auto q = [](double x) { return std::llround(x * 1e7); };
    return this->Ids
      .try_emplace(
        std::make_tuple(q(p.x()), q(p.y()), q(p.z())), static_cast<int>(this->Ids.size()))
      .first->second;
  }
  /// A chart over a grid of w x h squares; position(i, j) gives its points.
  void addGrid(
    int w, int h, const std::function<Vec3(int, int)>& position, const Vec2& extent = Vec2(1, 1))
  {
    std::vector<Vec3> points;
    std::vector<Triangle> triangles;
    vtkNew<vtkDoubleArray> uv;
    uv->SetName("UV");
    uv->SetNumberOfComponents(2);
    vtkNew<vtkIdTypeArray> ids;
    ids->SetName("SurfacePointId");
    vtkNew<vtkDoubleArray> field; // a linear function of position: interpolation must reproduce it
    field->SetName("Height");
    vtkNew<vtkIntArray> label;
    label->SetName("Label");
    for (int j = 0; j <= h; ++j)
    {
      for (int i = 0; i <= w; ++i)
      {
        points.push_back(position(i, j));
        uv->InsertNextTuple2(extent.x() * i / w, extent.y() * j / h);
        ids->InsertNextValue(this->pointAt(points.back()));
        field->InsertNextValue(points.back().x() + 2. * points.back().y() + 3. * points.back().z());
        label->InsertNextValue(points.back().x() > 0.5 ? 7 : 3);
      }
    }
    const auto at = [w](int i, int j) { return j * (w + 1) + i; };
    for (int j = 0; j < h; ++j)
    {
      for (int i = 0; i < w; ++i)
      {
        triangles.push_back({ at(i, j), at(i + 1, j), at(i + 1, j + 1) });
        triangles.push_back({ at(i, j), at(i + 1, j + 1), at(i, j + 1) });
      }
    }
    auto chart = toPolyData(points, triangles);
    vtkNew<vtkIdTypeArray> source;
    source->SetName("SourceCellId");
    vtkNew<vtkIntArray> material; // a cell array: the number of the chart
    material->SetName("Material");
    for (std::size_t t = 0; t < triangles.size(); ++t)
    {
      source->InsertNextValue(this->Cells++);
      material->InsertNextValue(static_cast<int>(this->Count));
    }
    chart->GetPointData()->AddArray(uv);
    chart->GetPointData()->SetActiveTCoords("UV");
    chart->GetPointData()->AddArray(ids);
    chart->GetPointData()->AddArray(field);
    chart->GetPointData()->AddArray(label);
    chart->GetCellData()->AddArray(source);
    chart->GetCellData()->AddArray(material);
    vtkNew<vtkDoubleArray> size;
    size->SetName("ChartExtent");
    size->SetNumberOfComponents(2);
    size->InsertNextTuple(extent.data());
    chart->GetFieldData()->AddArray(size);
    vtkNew<vtkPartitionedDataSet> set;
    set->SetPartition(0, chart);
    this->Result.charts->SetPartitionedDataSet(this->Count++, set);
  }
  void addBackbone(BackboneType type, const std::vector<Vec3>& curve, bool closed = false)
  {
    Backbone b;
    b.type = type;
    b.closed = closed;
    for (const Vec3& p : curve)
    {
      b.points.push_back(this->pointAt(p));
    }
    this->Result.graph.backbones.push_back(b);
  }
  MadeAtlas& finish()
  {
    FeatureGraph& graph = this->Result.graph;
    graph.isCorner.assign(this->Ids.size(), 0);
    for (const Backbone& b : graph.backbones)
    {
      if (!b.closed && b.type != BackboneType::Seam)
      {
        graph.isCorner[b.points.front()] = graph.isCorner[b.points.back()] = 1;
      }
    }
    this->Status_ = readAtlas(this->Result.charts, this->Result.surface).ok() &&
      traceBackbones(
        this->Result.surface, this->Result.surface.vertexHalfedges(), graph, this->Result.traces)
        .ok();
    this->Result.graphData = toPolyData(graph, this->Result.surface.points);
    return this->Result;
  }
  bool ok() const { return this->Status_; }
  MadeAtlas Result;

private:
  std::map<std::tuple<long long, long long, long long>, int> Ids;
  unsigned int Count = 0;
  vtkIdType Cells = 0;
  bool Status_ = false;
};

/// The points (i, j) of a grid on a straight run, both ends included.
template <typename Position>
std::vector<Vec3> run(const Position& position, int i0, int j0, int i1, int j1)
{
  const int n = std::max(std::abs(i1 - i0), std::abs(j1 - j0));
  std::vector<Vec3> curve;
  for (int k = 0; k <= n; ++k)
  {
    curve.push_back(position(i0 + (i1 - i0) * k / n, j0 + (j1 - j0) * k / n));
  }
  return curve;
}

/// A height field over the unit square, open, as charts x charts charts of n x n squares. With a
/// crease, it has a roof's ridge along x = 1/4, which runs inside the charts of the first column
/// (charts = 2).
inline void bumpyGrid(Builder& b, int charts, int n, bool crease = false)
{
  const int total = charts * n;
  const auto position = [=](int i, int j) {
    const double x = static_cast<double>(i) / total;
    const double y = static_cast<double>(j) / total;
    const double z = crease ? -std::abs(x - 0.25) : 0.08 * std::sin(7. * x) * std::cos(5. * y);
    return Vec3(x, y, z);
  };
  for (int cj = 0; cj < charts; ++cj)
  {
    for (int ci = 0; ci < charts; ++ci)
    {
      b.addGrid(n, n, [=](int i, int j) { return position(ci * n + i, cj * n + j); });
    }
  }
  for (int k = 0; k < charts; ++k)
  {
    const int p = k * n;
    const int q = p + n;
    b.addBackbone(BackboneType::Boundary, run(position, total, p, total, q));
    b.addBackbone(BackboneType::Boundary, run(position, p, total, q, total));
    b.addBackbone(BackboneType::Boundary, run(position, 0, p, 0, q));
    // The ridge ends on the outline, which it splits there.
    if (crease && k == 0)
    {
      b.addBackbone(BackboneType::Boundary, run(position, 0, 0, n / 2, 0));
      b.addBackbone(BackboneType::Boundary, run(position, n / 2, 0, n, 0));
    }
    else
    {
      b.addBackbone(BackboneType::Boundary, run(position, p, 0, q, 0));
    }
    for (int l = 1; l < charts; ++l)
    {
      b.addBackbone(BackboneType::Seam, run(position, l * n, p, l * n, q));
      if (!(crease && k == 0))
      {
        b.addBackbone(BackboneType::Seam, run(position, p, l * n, q, l * n));
      }
      else
      {
        b.addBackbone(BackboneType::Seam, run(position, 0, l * n, n / 2, l * n));
        b.addBackbone(BackboneType::Seam, run(position, n / 2, l * n, n, l * n));
      }
    }
  }
  if (crease)
  {
    for (int k = 0; k < charts; ++k)
    {
      // The last piece ends in the middle of the last chart: a dart.
      b.addBackbone(BackboneType::Sharp,
        run(position, n / 2, k * n, n / 2, k + 1 < charts ? (k + 1) * n : k * n + n / 2));
    }
  }
}

/// A cube of 6 charts: on the sphere (seams along its edges) or flat (sharp edges), of sides twice
/// `half`.
inline void cube(Builder& b, int n, bool sphere, const Vec3& half = Vec3::Ones())
{
  const auto place = [=](const Vec3& p) {
    return sphere ? Vec3(p.normalized()) : Vec3(p.cwiseProduct(half));
  };
  const auto at = [=](int i, int n_) {
    return sphere ? std::tan((2. * i / n_ - 1.) * Pi / 4) : 2. * i / n_ - 1.;
  };
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const int sign : { -1, 1 })
    {
      b.addGrid(n, n, [=](int i, int j) {
        Vec3 p;
        p[axis] = sign;
        p[(axis + 1) % 3] = sign * at(i, n);
        p[(axis + 2) % 3] = at(j, n);
        return place(p);
      });
    }
    for (const int s : { -1, 1 })
    {
      for (const int t : { -1, 1 })
      {
        std::vector<Vec3> curve;
        for (int i = 0; i <= n; ++i)
        {
          Vec3 p;
          p[axis] = at(i, n);
          p[(axis + 1) % 3] = s;
          p[(axis + 2) % 3] = t;
          curve.push_back(place(p));
        }
        b.addBackbone(sphere ? BackboneType::Seam : BackboneType::Sharp, curve);
      }
    }
  }
}

/// A torus cut open into one chart: both cuts start and end in the same point, and join the chart
/// to itself.
inline void torus(Builder& b, int m, int n)
{
  const auto position = [=](int i, int j) {
    const double u = 2. * Pi * (i % m) / m;
    const double v = 2. * Pi * (j % n) / n;
    const double r = 1. + 0.4 * std::cos(v);
    return Vec3(r * std::cos(u), r * std::sin(u), 0.4 * std::sin(v));
  };
  b.addGrid(m, n, position, Vec2(1., 0.4));
  b.addBackbone(BackboneType::Seam, run(position, 0, 0, m, 0));
  b.addBackbone(BackboneType::Seam, run(position, 0, 0, 0, n));
}

/// n samples: the nodes, jittered ones along the backbones, and darts thrown on the surface.
inline std::vector<Sample> sample(const AtlasSurface& s, const FeatureGraph& graph,
  const std::vector<BackboneTrace>& traces, int n, unsigned int seed = 1)
{
  std::mt19937 engine(seed); // its output is fixed by the standard; the distributions' is not
  const auto random = [&]() { return engine() / 4294967296.; };
  std::vector<Sample> samples;
  const double spacing = std::sqrt(s.area() / n * 2. / std::sqrt(3.));
  std::map<std::array<int, 3>, std::vector<Vec3>> where; // by cell of a lattice
  const auto cell = [&](const Vec3& p, int k) {
    return static_cast<int>(std::floor(p[k] / spacing));
  };
  const auto add = [&](Sample x) {
    samples.push_back(x);
    const Vec3 p = s.position(x.face, x.bary);
    where[{ cell(p, 0), cell(p, 1), cell(p, 2) }].push_back(p);
  };
  const auto first = s.vertexHalfedges();
  for (int p : graph.nodes())
  {
    Sample x;
    x.kind = SampleKind::Corner;
    x.surfacePoint = p;
    x.face = first[p] / 3;
    x.bary[first[p] % 3] = 1;
    add(x);
  }
  for (std::size_t b = 0; b < traces.size(); ++b)
  {
    const BackboneTrace& trace = traces[b];
    const bool closed = graph.backbones[b].closed;
    const int pieces =
      std::max(closed ? 3 : 1, static_cast<int>(std::lround(trace.length() / spacing)));
    for (int i = closed ? 0 : 1; i < pieces; ++i)
    {
      Sample x;
      x.kind = SampleKind::Backbone;
      x.backbone = static_cast<int>(b);
      x.arcLength = trace.length() * (i + 0.5 * (random() - 0.5) + (closed ? 0.5 : 0.)) / pieces;
      const BackboneTrace::Place place = trace.locate(x.arcLength);
      const int side = trace.hasSide(0) ? 0 : 1;
      x.face = trace.face(place, side);
      x.bary = trace.bary(place, side);
      add(x);
    }
  }
  std::vector<double> area = { 0 };
  for (int f = 0; f < s.numberOfFaces(); ++f)
  {
    area.push_back(area.back() + s.faceArea(f));
  }
  int failed = 0;
  double radius = 0.75 * spacing;
  while (static_cast<int>(samples.size()) < n)
  {
    Sample x;
    x.face =
      static_cast<int>(std::upper_bound(area.begin() + 1, area.end() - 1, random() * area.back()) -
        area.begin() - 1);
    double u = random();
    double v = random();
    if (u + v > 1)
    {
      u = 1 - u;
      v = 1 - v;
    }
    x.bary = Vec3(1 - u - v, u, v);
    const Vec3 p = s.position(x.face, x.bary);
    bool near = false;
    for (int k = 0; k < 27 && !near; ++k)
    {
      const auto found =
        where.find({ cell(p, 0) + k % 3 - 1, cell(p, 1) + k / 3 % 3 - 1, cell(p, 2) + k / 9 - 1 });
      if (found != where.end())
      {
        for (const Vec3& q : found->second)
        {
          near = near || (q - p).squaredNorm() < radius * radius;
        }
      }
    }
    if (!near)
    {
      add(x);
      failed = 0;
    }
    else if (++failed > 200)
    {
      radius *= 0.95;
      failed = 0;
    }
  }
  return samples;
}

inline std::vector<Sample> sample(const MadeAtlas& atlas, int n, unsigned int seed = 1)
{
  return sample(atlas.surface, atlas.graph, atlas.traces, n, seed);
}
}

#endif
