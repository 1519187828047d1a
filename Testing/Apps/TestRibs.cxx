// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The paper's Figure 8 in numbers: with the rib preset, vertices on the creases of the fandisk have
// two neighbours on each side, however coarse the mesh is, and neither flipped triangles nor the
// distance from the model are the price.
#include "PolyDataConversion.h"
#include "TestModels.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkGenericCell.h"
#include "vtkGeometryRemesher.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRemeshOptimizer.h"
#include "vtkStaticCellLocator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace stipple;

namespace
{
using Edge = std::pair<vtkIdType, vtkIdType>;

/// The mesh's edges along sharp and boundary backbones, both ways.
std::set<Edge> creasesOf(vtkPolyData* lines)
{
  std::set<Edge> edges;
  vtkDataArray* type = lines->GetCellData()->GetArray("BackboneType");
  vtkNew<vtkIdList> line;
  for (vtkIdType c = 0; c < lines->GetNumberOfLines(); ++c)
  {
    lines->GetLines()->GetCellAtId(c, line);
    for (vtkIdType i = 1; type->GetTuple1(c) < 2 && i < line->GetNumberOfIds(); ++i)
    {
      edges.insert({ line->GetId(i - 1), line->GetId(i) });
      edges.insert({ line->GetId(i), line->GetId(i - 1) });
    }
  }
  return edges;
}

struct Ribs
{
  int vertices = 0;   ///< on creases, corners left out
  int complete = 0;   ///< of them, with two neighbours on each side
  int creases = 0;    ///< edges
  int edges = 0;      ///< of creases that are edges of the mesh
  double angle = 180; ///< the smallest
};

Ribs countRibs(vtkPolyData* mesh, vtkPolyData* lines)
{
  const std::set<Edge> crease = creasesOf(lines);
  // The neighbour after another one, counterclockwise about a vertex
  std::vector<std::map<vtkIdType, vtkIdType>> next(mesh->GetNumberOfPoints());
  Ribs ribs;
  vtkNew<vtkIdList> ids;
  for (vtkIdType f = 0; f < mesh->GetNumberOfPolys(); ++f)
  {
    mesh->GetPolys()->GetCellAtId(f, ids);
    for (int k = 0; k < 3; ++k)
    {
      const vtkIdType a = ids->GetId(k);
      const vtkIdType b = ids->GetId((k + 1) % 3);
      const vtkIdType c = ids->GetId((k + 2) % 3);
      next[a][b] = c;
      ribs.edges += crease.count({ a, b }) > 0;
      const Vec3 p(mesh->GetPoint(a));
      const Vec3 u = Vec3(mesh->GetPoint(b)) - p;
      const Vec3 v = Vec3(mesh->GetPoint(c)) - p;
      ribs.angle =
        std::min(ribs.angle, std::atan2(u.cross(v).norm(), u.dot(v)) * 180. / std::acos(-1.));
    }
  }
  ribs.creases = static_cast<int>(crease.size());
  vtkDataArray* kind = mesh->GetPointData()->GetArray("SampleKind");
  for (vtkIdType v = 0; v < mesh->GetNumberOfPoints(); ++v)
  {
    std::vector<vtkIdType> along;
    for (const auto& [u, after] : next[v])
    {
      if (crease.count({ v, u }))
      {
        along.push_back(u);
      }
    }
    if (kind->GetTuple1(v) != 1 || along.size() != 2)
    {
      continue;
    }
    const auto neighboursFrom = [&](vtkIdType u) {
      int count = 0;
      for (u = next[v].at(u); !crease.count({ v, u }); u = next[v].at(u))
      {
        ++count;
      }
      return count;
    };
    ++ribs.vertices;
    ribs.complete += neighboursFrom(along[0]) == 2 && neighboursFrom(along[1]) == 2;
  }
  return ribs;
}

/// The place of a surface that is nearest to a point.
class Nearest
{
public:
  explicit Nearest(vtkPolyData* surface)
  {
    this->Locator->SetDataSet(surface);
    this->Locator->BuildLocator();
  }
  /// Its distance, and the id of its triangle.
  std::pair<double, vtkIdType> operator()(const Vec3& p)
  {
    Vec3 on;
    vtkIdType cell = -1;
    int sub = 0;
    double squared = 0;
    this->Locator->FindClosestPoint(p.data(), on.data(), this->Cell, cell, sub, squared);
    return { std::sqrt(squared), cell };
  }

private:
  vtkNew<vtkStaticCellLocator> Locator;
  vtkNew<vtkGenericCell> Cell;
};

Vec3 normalOf(vtkPolyData* mesh, vtkIdType triangle)
{
  vtkNew<vtkIdList> ids;
  mesh->GetCellPoints(triangle, ids);
  const Vec3 p(mesh->GetPoint(ids->GetId(0)));
  return (Vec3(mesh->GetPoint(ids->GetId(1))) - p).cross(Vec3(mesh->GetPoint(ids->GetId(2))) - p);
}

/// Triangles that turn away from the model where it is nearest to their centroid, by more than 100
/// degrees: the nearest place of one on a narrow step may be on the wall below, at a right angle.
int countFlipped(vtkPolyData* mesh, vtkPolyData* model)
{
  Nearest nearest(model);
  int flipped = 0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType f = 0; f < mesh->GetNumberOfPolys(); ++f)
  {
    mesh->GetCellPoints(f, ids);
    Vec3 sum = Vec3::Zero();
    for (int k = 0; k < 3; ++k)
    {
      sum += Vec3(mesh->GetPoint(ids->GetId(k)));
    }
    const double cosine =
      normalOf(mesh, f).normalized().dot(normalOf(model, nearest(sum / 3.).second).normalized());
    flipped += cosine < std::cos(100. / 180. * std::acos(-1.)) ? 1 : 0;
  }
  return flipped;
}

/// The largest distance of the model's points from the mesh, in % of the model's diagonal.
double errorOf(vtkPolyData* mesh, vtkPolyData* model)
{
  Nearest nearest(mesh);
  double largest = 0;
  for (vtkIdType p = 0; p < model->GetNumberOfPoints(); ++p)
  {
    largest = std::max(largest, nearest(Vec3(model->GetPoint(p))).first);
  }
  return 100. * largest / model->GetLength();
}

Ribs remesh(vtkGeometryRemesher* remesher, vtkPolyData* model, int points)
{
  remesher->SetInputData(model);
  remesher->SetNumberOfPoints(points);
  remesher->Update();
  EXPECT_EQ(remesher->GetOutput()->GetNumberOfPoints(), points);
  return countRibs(
    remesher->GetOutput(), vtkPolyData::SafeDownCast(remesher->GetOutputDataObject(1)));
}
}

TEST(Ribs, Fandisk)
{
  const vtkSmartPointer<vtkPolyData> model = readModel("fandisk");
  vtkNew<vtkGeometryRemesher> plain;
  vtkNew<vtkGeometryRemesher> ribbed;
  ribbed->SetPresetToRib();
  const Ribs without = remesh(plain, model, 1000);
  EXPECT_LT(without.complete, 0.85 * without.vertices) << "the default has ribs, too";
  plain->GetOptimizer()->SetFeatureTolerance(0.); // ribs leave creases the vertices that they have
  for (const int points :
    { 200, 205, 210, 220, 240, 260, 300, 400, 600, 1000, 1400, 2500, 5000, 10000 })
  {
    SCOPED_TRACE(std::to_string(points) + " points");
    const Ribs ribs = remesh(ribbed, model, points);
    // The mesh is closed: every edge of a crease is met once from either side.
    EXPECT_EQ(ribs.edges, ribs.creases);
    EXPECT_GE(ribs.complete, (points < 2500 ? 0.95 : 0.99) * ribs.vertices);
    // Where creases are an edge apart, coarse meshes pay with their angles.
    EXPECT_GT(ribs.angle, points < 600 ? 14. : 19.);
    EXPECT_EQ(countFlipped(ribbed->GetOutput(), model), 0);
    // Creases of few vertices are the first to lie far from the surface's.
    remesh(plain, model, points);
    EXPECT_LT(errorOf(ribbed->GetOutput(), model), 1.25 * errorOf(plain->GetOutput(), model));
  }
}

// Holes a few edges wide, beside which it is easy to flip a triangle: one whose centroid is nearest
// to the rim turns away from the hole's wall, if not from the plane about it. Without regard to
// that there are two at 700 points and one at 1,000.
TEST(Ribs, Anchor)
{
  const vtkSmartPointer<vtkPolyData> model = readModel("anchor_dense");
  vtkNew<vtkGeometryRemesher> remesher;
  remesher->SetPresetToRib();
  // Those where seams cross creases count, too; while they did not slide, .78 had ribs of 700.
  const std::map<int, double> shares = { { 700, 0.8 }, { 1000, 0.9 }, { 2000, 0.9 },
    { 5000, 0.99 } };
  for (const auto& [points, share] : shares)
  {
    SCOPED_TRACE(std::to_string(points) + " points");
    const Ribs ribs = remesh(remesher, model, points);
    EXPECT_EQ(ribs.edges, ribs.creases);
    EXPECT_GE(ribs.complete, share * ribs.vertices);
    EXPECT_EQ(countFlipped(remesher->GetOutput(), model), 0);
  }
}
