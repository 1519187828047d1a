// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Bytes as a small surface and a few options for the whole pipeline. The surface begins as a grid,
// a tube, a Moebius strip, a torus, a Klein bottle, a sphere or nothing, and is then spoiled, edit
// by edit: triangles doubled, turned, left out, added; points moved onto others, far away, next to
// nothing, or to where there is no number. What comes out is a sentence and no mesh, or a mesh that
// keeps the contract: exactly so many points, manifold, the topology of the repaired surface, no
// triangle without an area.
#include "MeshQuality.h"
#include "Messages.h"
#include "OptionTable.h"
#include "PolyDataConversion.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkConformalAtlas.h"
#include "vtkGeometryRemesher.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <map>
#include <string>
#include <vector>

using namespace stipple;

namespace
{
/// The bytes one by one, then zeros.
class Bytes
{
public:
  Bytes(const std::uint8_t* data, std::size_t size)
    : Data(data)
    , Size(size)
  {
  }
  bool atEnd() const { return this->Next >= this->Size; }
  int next() { return this->atEnd() ? 0 : this->Data[this->Next++]; }
  int below(int n) { return n < 1 ? 0 : this->next() % n; }
  /// Of 0 to n - 1, by two bytes.
  int index(int n)
  {
    const int high = this->next();
    return n < 1 ? 0 : (256 * high + this->next()) % n;
  }
  double fraction() { return this->next() / 255.; }

private:
  const std::uint8_t* Data;
  std::size_t Size;
  std::size_t Next = 0;
};

struct Soup
{
  std::vector<Vec3> points;
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> labels; // by triangle
};

/// A grid of (m + 1) x (n + 1) points over [0, 1]^2, with sides glued as the shape wants it.
Soup makeShape(int shape, int m, int n)
{
  enum Shape
  {
    Nothing,
    Plane,
    Tube,
    Moebius,
    Torus,
    Klein,
    Sphere
  };
  Soup soup;
  if (shape == Nothing)
  {
    return soup;
  }
  const double turn = 2 * std::acos(-1.);
  const auto place = [&](double u, double v) -> Vec3 {
    const double a = turn * u;
    const double b = turn * v;
    const double w = v - .5;
    switch (shape)
    {
      case Tube:
        return { std::cos(a), std::sin(a), 2 * v };
      case Moebius:
        return { (2 + w * std::cos(a / 2)) * std::cos(a), (2 + w * std::cos(a / 2)) * std::sin(a),
          w * std::sin(a / 2) };
      case Torus:
        return { (2 + std::cos(b)) * std::cos(a), (2 + std::cos(b)) * std::sin(a), std::sin(b) };
      case Klein: // in figure 8
        return { (2 + std::cos(a / 2) * std::sin(b) - std::sin(a / 2) * std::sin(2 * b)) *
            std::cos(a),
          (2 + std::cos(a / 2) * std::sin(b) - std::sin(a / 2) * std::sin(2 * b)) * std::sin(a),
          std::sin(a / 2) * std::sin(b) + std::cos(a / 2) * std::sin(2 * b) };
      case Sphere:
        return { std::sin(b / 2) * std::cos(a), std::sin(b / 2) * std::sin(a), std::cos(b / 2) };
      default:
        return { u, v, 0.1 * std::sin(a) };
    }
  };
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= m; ++i)
    {
      soup.points.push_back(place(static_cast<double>(i) / m, static_cast<double>(j) / n));
    }
  }
  const auto point = [&](int i, int j) {
    if (i == m && shape != Plane)
    {
      i = 0;
      j = shape == Moebius ? n - j : (shape == Klein ? (2 * n - j) % n : j);
    }
    if (j == n && (shape == Torus || shape == Klein))
    {
      j = 0;
    }
    if (shape == Sphere && (j == 0 || j == n))
    {
      i = 0;
    }
    return j * (m + 1) + i;
  };
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < m; ++i)
    {
      const std::array<int, 4> q = { point(i, j), point(i + 1, j), point(i + 1, j + 1),
        point(i, j + 1) };
      soup.triangles.push_back({ q[0], q[1], q[2] });
      soup.triangles.push_back({ q[0], q[2], q[3] });
    }
  }
  return soup;
}

void spoil(Soup& soup, Bytes& bytes)
{
  constexpr std::size_t Most = 600;
  const int points = static_cast<int>(soup.points.size());
  const int triangles = static_cast<int>(soup.triangles.size());
  const int edit = bytes.below(12);
  if (edit < 2 && soup.points.size() < Most)
  {
    soup.points.push_back({ bytes.fraction(), bytes.fraction(), bytes.fraction() });
    return;
  }
  if (points == 0)
  {
    return;
  }
  const int p = bytes.index(points);
  const int t = bytes.index(triangles);
  switch (edit)
  {
    case 2: // a triangle of any three points
    case 3:
      if (soup.triangles.size() < Most)
      {
        soup.triangles.push_back({ p, bytes.index(points), bytes.index(points) });
      }
      break;
    case 4: // onto another point
      soup.points[p] = soup.points[bytes.index(points)];
      break;
    case 5: // a little, or much
    {
      const double by = std::pow(2., bytes.below(64) - 56.);
      soup.points[p] +=
        by * Vec3(bytes.fraction() - .5, bytes.fraction() - .5, bytes.fraction() - .5);
      break;
    }
    case 6: // where numbers end
    {
      constexpr std::array<double, 8> odd = { 1e150, -1e150, 1e-150, 5e-324, -0.,
        std::numeric_limits<double>::max(), std::numeric_limits<double>::infinity(),
        std::numeric_limits<double>::quiet_NaN() };
      soup.points[p][bytes.below(3)] = odd[bytes.below(static_cast<int>(odd.size()))];
      break;
    }
    case 7: // the whole, along an axis
    {
      const int axis = bytes.below(3);
      const double factor =
        std::pow(10., (bytes.below(41) - 20) * (bytes.below(8) == 0 ? 8. : .25));
      for (Vec3& x : soup.points)
      {
        x[axis] *= factor;
      }
      break;
    }
    case 8: // far from the origin
    {
      const double by = std::pow(10., bytes.below(10));
      for (Vec3& x : soup.points)
      {
        x[0] += by;
      }
      break;
    }
    default:
      if (triangles == 0)
      {
        break;
      }
      if (edit == 9)
      {
        std::swap(soup.triangles[t][0], soup.triangles[t][1]);
      }
      else if (edit == 10)
      {
        soup.triangles.erase(soup.triangles.begin() + t);
      }
      else if (soup.triangles.size() < Most)
      {
        soup.triangles.push_back(soup.triangles[t]);
      }
  }
}

vtkSmartPointer<vtkPolyData> toPolyData(const Soup& soup)
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vec3& x : soup.points)
  {
    points->InsertNextPoint(x.data());
  }
  vtkNew<vtkCellArray> polys;
  vtkNew<vtkIntArray> labels;
  labels->SetName("Label");
  for (std::size_t i = 0; i < soup.triangles.size(); ++i)
  {
    const std::array<vtkIdType, 3> ids = { soup.triangles[i][0], soup.triangles[i][1],
      soup.triangles[i][2] };
    polys->InsertNextCell(3, ids.data());
    labels->InsertNextValue(static_cast<int>(i / 7 % 3));
  }
  mesh->SetPoints(points);
  mesh->SetPolys(polys);
  mesh->GetCellData()->AddArray(labels);
  return mesh;
}

double diagonalOf(const Soup& soup)
{
  Vec3 low = Vec3::Constant(1e300);
  Vec3 high = -low;
  for (const Vec3& x : soup.points)
  {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  const double d = soup.points.empty() ? 0. : (high - low).norm();
  return std::isfinite(d) && d > 0 ? d : 1.;
}

/// Sets one option of the table. What costs time only has a limit here.
void choose(OptionValues& options, const Soup& soup, Bytes& bytes)
{
  static const std::map<std::string, double> most = { { "charts", 12 }, { "map_size", 96 },
    { "iterations", 12 }, { "subdivisions", 2 }, { "subdivision_iterations", 3 },
    { "curvature_points", 40 }, { "error_reduction", 30 }, { "max_deviation", 60 },
    { "maximum_density_ratio", 1000 }, { "gamma", 8 } };
  static const std::vector<std::string> lengths = { "edge_length", "size_minimum", "size_maximum",
    "max_deviation_length" };
  const std::vector<Option>& table = optionTable();
  const Option& option = table[bytes.below(static_cast<int>(table.size()))];
  const double at = bytes.fraction();
  if (option.name == "select_array" || option.name == "region_array")
  {
    options.set(option.name, std::string("Label"));
    return;
  }
  if (option.stage.empty() || option.name == "map_backend" || option.name == "points")
  {
    return;
  }
  using Kind = Option::Kind;
  if (option.kind == Kind::Choice)
  {
    options.set(option.name, option.choices[bytes.below(static_cast<int>(option.choices.size()))]);
  }
  else if (std::find(lengths.begin(), lengths.end(), option.name) != lengths.end())
  {
    options.set(option.name, diagonalOf(soup) * (.03 + at));
  }
  else if (option.kind == Kind::Integer || option.kind == Kind::Number)
  {
    const auto limit = most.find(option.name);
    const double high = limit == most.end() ? option.high : std::min(option.high, limit->second);
    const double value = option.low + at * at * at * (high - option.low);
    options.set(option.name, option.kind == Kind::Integer ? std::round(value) : value);
  }
  else if (option.kind == Kind::Text)
  {
    options.set(option.name, std::string(bytes.below(2) ? "Label" : "none such"));
  }
  else if (option.kind == Kind::Rows)
  {
    std::vector<double> numbers;
    const int rows = option.oneRow ? 1 : bytes.below(4);
    for (int i = 0; i < rows; ++i)
    {
      const Vec3 x = soup.points.empty()
        ? Vec3(0, 0, 0)
        : soup.points[bytes.index(static_cast<int>(soup.points.size()))];
      for (std::size_t k = 0; k < option.columns.size(); ++k)
      {
        const Option::Column& column = option.columns[k];
        numbers.push_back(column.whole                          ? bytes.next()
            : k < 3 && !std::isfinite(column.high - column.low) ? x[static_cast<int>(k)]
                                                                : 2 * bytes.fraction());
      }
    }
    if (option.wrongRows(numbers).empty())
    {
      options.setList(option.name, numbers);
    }
  }
}

void insist(bool holds, const std::string& what)
{
  if (!holds)
  {
    std::fprintf(stderr, "broken promise: %s\n", what.c_str());
    std::abort();
  }
}

void lookAtMesh(vtkGeometryRemesher* remesher, const OptionValues& options, int points)
{
  vtkPolyData* mesh = remesher->GetOutput();
  double x[3];
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    mesh->GetPoint(p, x);
    insist(std::all_of(x, x + 3, [](double c) { return std::isfinite(c); }), "points are finite");
  }
  const std::string pattern = options.text("pattern");
  const bool numberFollows = options.has("edge_length") || options.has("max_deviation") ||
    options.has("max_deviation_length");
  if (pattern == "quads" || options.has("select_array"))
  {
    return;
  }
  insist(
    numberFollows || pattern != "triangles" || points == 0 || mesh->GetNumberOfPoints() == points,
    std::to_string(mesh->GetNumberOfPoints()) + " points instead of " + std::to_string(points));
  TriangleSurface surface = fromPolyData(mesh);
  surface.connect();
  const MeshQuality q = measureQuality(surface);
  insist(q.isolatedPoints == 0, "points have triangles");
  insist(q.nonManifoldEdges + q.nonManifoldVertices + q.misorientedEdges == 0, "it is manifold");
  insist(q.degenerate == 0, "triangles have an area");
  vtkConformalAtlas* atlas = remesher->GetAtlas();
  insist(q.components == atlas->GetNumberOfComponents() &&
      q.boundaryLoops == atlas->GetNumberOfBoundaryLoops() &&
      q.euler == atlas->GetEulerCharacteristic(),
    "it has the topology of the surface");
}
}

extern "C" int LLVMFuzzerInitialize(int*, char***)
{
  static const auto window = CollectingOutputWindow::install();
  vtkSMPTools::Initialize(1);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  Bytes bytes(data, size);
  const int shape = bytes.below(7);
  const int m = 3 + bytes.below(9);
  const int n = 3 + bytes.below(9);
  Soup soup = makeShape(shape, m, n);
  constexpr std::array<int, 4> coarse = { 0, 1, 12, 40 };
  const int kind = bytes.below(8);
  const int points = kind < 4 ? coarse[kind] : 50 + 2 * bytes.next();
  OptionValues options;
  options.set("map_size", 64);
  while (!bytes.atEnd())
  {
    if (bytes.below(3) == 0)
    {
      choose(options, soup, bytes);
    }
    else
    {
      spoil(soup, bytes);
    }
  }
  vtkNew<vtkGeometryRemesher> remesher;
  options.set("points", points);
  options.set("map_backend", std::string("cpu"));
  applyOptions(options, remesher);
  remesher->SetInputData(toPolyData(soup));
  const ErrorCollector errors(remesher);
  remesher->Update();
  const bool failed = remesher->GetErrorCode() != 0;
  insist(failed == !errors.first().empty(), "what fails says so: " + errors.first());
  insist(remesher->GetErrorCode() != vtkGeometryRemesher::INTERNAL_ERROR, errors.first());
  insist(!failed || remesher->GetOutput()->GetNumberOfPoints() == 0, "no mesh after an error");
  if (remesher->GetOutput()->GetNumberOfPolys() > 0)
  {
    lookAtMesh(remesher, options, points);
  }
  return 0;
}
