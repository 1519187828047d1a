// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BlockBorders.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <tuple>

namespace stipple
{
namespace
{
/// Cosine of the turn from which on a crease that is a border has a corner, as
/// vtkConformalAtlas::CornerAngle has it by default: 60 degrees.
constexpr double CornerCosine = 0.5;
/// Nearer to a vertex than this share of the edge, a sample is put on it: thin triangles would
/// come of it.
constexpr double NearVertex = 0.1;

struct Edge
{
  long long low = -1;
  long long high = -1;
  Vec3 xLow;
  Vec3 xHigh;
  std::array<double, 2> density = { { 1, 1 } };
  std::array<int, 2> blocks = { { -1, -1 } };
  bool isCrease = false;
};

Vec3 vectorOf(const std::array<double, 3>& x)
{
  return { x[0], x[1], x[2] };
}

/// A chain of points with the edges between them.
struct Path
{
  std::vector<long long> points;
  std::vector<int> edges;
  std::vector<Vec3> x;
  std::vector<double> spacing; // by point

  struct Place
  {
    std::size_t segment = 0;
    double t = 0;
  };
  Vec3 at(const Place& p) const
  {
    return (1. - p.t) * this->x[p.segment] + p.t * this->x[p.segment + 1];
  }
  double spacingAt(const Place& p) const
  {
    return (1. - p.t) * this->spacing[p.segment] + p.t * this->spacing[p.segment + 1];
  }

  /// The next place that is so far away, or false if the end comes before.
  bool advance(Place& place, double distance) const
  {
    const Vec3 from = this->at(place);
    double t = place.t;
    for (std::size_t s = place.segment; s + 1 < this->x.size(); ++s, t = 0)
    {
      if ((this->x[s + 1] - from).norm() < distance)
      {
        continue;
      }
      // |a + u d| = distance, for the larger root.
      const Vec3 d = this->x[s + 1] - this->x[s];
      const Vec3 a = this->x[s] - from;
      const double dd = d.squaredNorm();
      const double ad = a.dot(d);
      const double root =
        std::sqrt(std::max(0., ad * ad - dd * (a.squaredNorm() - distance * distance)));
      place = { s, dd > 0 ? std::clamp((root - ad) / dd, t, 1.) : 1. };
      return true;
    }
    return false;
  }

  /// How many steps of `scale` times the spacing there are, the last one in part.
  double count(double scale, std::vector<Place>* places = nullptr) const
  {
    constexpr double Most = 1e7;
    Place place;
    double steps = 0;
    while (steps < Most)
    {
      const double step = scale * this->spacingAt(place);
      if (!this->advance(place, step))
      {
        return steps + std::min(1., (this->x.back() - this->at(place)).norm() / step);
      }
      steps += 1;
      if (places)
      {
        places->push_back(place);
      }
    }
    return steps;
  }

  /// The ends of n steps but the last one's, which is the path's.
  std::vector<Place> divide(int n) const
  {
    double low = 1e-3;
    double high = 1e3;
    for (int i = 0; i < 60; ++i)
    {
      const double middle = std::sqrt(low * high);
      (this->count(middle) > n ? low : high) = middle;
    }
    std::vector<Place> places;
    this->count(low, &places);
    if (static_cast<int>(places.size()) + 1 < n)
    {
      // The path comes so close to itself that it cannot be told by distances: by its length.
      places.clear();
      std::vector<double> length(1, 0.);
      for (std::size_t s = 0; s + 1 < this->x.size(); ++s)
      {
        length.push_back(length.back() + (this->x[s + 1] - this->x[s]).norm());
      }
      for (int i = 1; i < n; ++i)
      {
        const double wanted = length.back() * i / n;
        const auto s = static_cast<std::size_t>(
          std::upper_bound(length.begin() + 1, length.end() - 1, wanted) - length.begin() - 1);
        const double part = length[s + 1] - length[s];
        places.push_back({ s, part > 0 ? std::clamp((wanted - length[s]) / part, 0., 1.) : 0. });
      }
    }
    places.resize(static_cast<std::size_t>(n - 1));
    return places;
  }
};

class BorderGraph
{
public:
  BorderGraph(double scale, BlockBorders& borders)
    : Scale(scale)
    , Borders(borders)
  {
  }

  Status match(std::vector<OpenEdge> open)
  {
    const auto key = [](const OpenEdge& e) {
      return std::tuple(
        std::min(e.point[0], e.point[1]), std::max(e.point[0], e.point[1]), e.block, e.point[0]);
    };
    std::sort(open.begin(), open.end(),
      [&](const OpenEdge& a, const OpenEdge& b) { return key(a) < key(b); });
    for (std::size_t i = 0; i < open.size();)
    {
      std::size_t end = i;
      const auto low = std::min(open[i].point[0], open[i].point[1]);
      const auto high = std::max(open[i].point[0], open[i].point[1]);
      const auto isSame = [&](const OpenEdge& e) {
        return std::min(e.point[0], e.point[1]) == low && std::max(e.point[0], e.point[1]) == high;
      };
      while (end < open.size() && isSame(open[end]))
      {
        this->BlocksAt[open[end].point[0]].insert(open[end].block);
        this->BlocksAt[open[end].point[1]].insert(open[end].block);
        if (open[end].hasFeature != 0)
        {
          this->Nodes.insert(open[end].point[0]);
        }
        ++end;
      }
      const std::string name =
        "The edge of the points " + std::to_string(low) + " and " + std::to_string(high);
      if (end - i > 2 || (end - i == 2 && open[i].block == open[i + 1].block))
      {
        return Status::error(name +
          " has more than two triangles, or two that face opposite ways, where the surface is cut "
          "into blocks: repair the surface first, or use larger blocks.");
      }
      if (end - i == 1)
      {
        this->Borders.boundary.push_back(open[i].point);
        this->Nodes.insert({ low, high });
      }
      else
      {
        if (open[i].point == open[i + 1].point)
        {
          return Status::error(
            name + " has two triangles that face opposite ways: orient the surface first.");
        }
        Edge edge;
        const int tail = open[i].point[0] == low ? 0 : 1;
        edge.low = low;
        edge.high = high;
        edge.xLow = vectorOf(open[i].x[tail]);
        edge.xHigh = vectorOf(open[i].x[1 - tail]);
        edge.density = { { open[i].density[tail], open[i].density[1 - tail] } };
        edge.blocks = { { open[i].block, open[i + 1].block } };
        edge.isCrease = open[i].isCrease != 0 || open[i + 1].isCrease != 0;
        this->At[low].push_back(static_cast<int>(this->Edges.size()));
        this->At[high].push_back(static_cast<int>(this->Edges.size()));
        this->Edges.push_back(edge);
      }
      i = end;
    }
    return Status::success();
  }

  void sample()
  {
    for (const auto& [point, edges] : this->At)
    {
      if (this->isNode(point, edges))
      {
        this->IsNode.insert(point);
        this->addAtPoint(point, true);
      }
    }
    std::vector<char> isDone(this->Edges.size(), 0);
    std::vector<Path> paths;
    std::map<std::array<long long, 2>, int> between; // nodes
    const auto trace = [&](long long from, int first) {
      Path path;
      path.points.push_back(from);
      int e = first;
      for (;;)
      {
        isDone[e] = 1;
        path.edges.push_back(e);
        const long long next =
          this->Edges[e].low == path.points.back() ? this->Edges[e].high : this->Edges[e].low;
        path.points.push_back(next);
        const std::vector<int>& there = this->At.at(next);
        if (this->IsNode.count(next) > 0 || next == from)
        {
          break;
        }
        e = there[0] == e ? there[1] : there[0];
      }
      for (const long long p : path.points)
      {
        path.x.push_back(this->positionOf(p));
        path.spacing.push_back(this->spacingAt(p));
      }
      ++between[{ { std::min(path.points.front(), path.points.back()),
        std::max(path.points.front(), path.points.back()) } }];
      paths.push_back(std::move(path));
    };
    for (const long long node : this->IsNode)
    {
      for (const int e : this->At.at(node))
      {
        if (!isDone[e])
        {
          trace(node, e);
        }
      }
    }
    for (std::size_t e = 0; e < this->Edges.size(); ++e) // loops without a node
    {
      if (!isDone[e])
      {
        trace(this->Edges[e].low, static_cast<int>(e));
      }
    }
    for (const Path& path : paths)
    {
      const bool isLoop = path.points.front() == path.points.back();
      const bool isAlone = between[{ { std::min(path.points.front(), path.points.back()),
                             std::max(path.points.front(), path.points.back()) } }] == 1;
      const int least = isLoop ? 3 : isAlone ? 1 : 2;
      this->place(path, std::max(least, static_cast<int>(std::lround(path.count(1.)))));
    }
  }

private:
  const Edge& edgeAt(long long point) const { return this->Edges[this->At.at(point).front()]; }
  Vec3 positionOf(long long point) const
  {
    const Edge& e = this->edgeAt(point);
    return e.low == point ? e.xLow : e.xHigh;
  }
  double spacingAt(long long point) const
  {
    const Edge& e = this->edgeAt(point);
    return std::sqrt(2. / (std::sqrt(3.) * this->Scale * e.density[e.low == point ? 0 : 1]));
  }

  bool isNode(long long point, const std::vector<int>& edges) const
  {
    if (edges.size() != 2 || this->Nodes.count(point) > 0)
    {
      return true;
    }
    const Edge& a = this->Edges[edges[0]];
    const Edge& b = this->Edges[edges[1]];
    if (a.blocks != b.blocks || a.isCrease != b.isCrease)
    {
      return true;
    }
    const Vec3 x = this->positionOf(point);
    const Vec3 u = (x - (a.low == point ? a.xHigh : a.xLow)).normalized();
    const Vec3 v = ((b.low == point ? b.xHigh : b.xLow) - x).normalized();
    return a.isCrease && u.dot(v) < CornerCosine;
  }

  int addAtPoint(long long point, bool isNode)
  {
    const auto [found, isNew] =
      this->Borders.atPoint.try_emplace(point, static_cast<int>(this->Borders.samples.size()));
    if (isNew)
    {
      BorderSample sample;
      sample.a = point;
      sample.position = this->positionOf(point);
      const std::set<int>& blocks = this->BlocksAt.at(point);
      sample.blocks.assign(blocks.begin(), blocks.end());
      const std::vector<int>& edges = this->At.at(point);
      sample.isHeld = isNode &&
        (this->Nodes.count(point) > 0 ||
          std::any_of(edges.begin(), edges.end(), [&](int e) { return this->Edges[e].isCrease; }));
      this->Borders.samples.push_back(sample);
    }
    return found->second;
  }

  void place(const Path& path, int steps)
  {
    BorderCurve curve;
    const Edge& first = this->Edges[path.edges.front()];
    curve.blocks = first.blocks;
    curve.isCrease = first.isCrease;
    curve.samples.push_back(this->addAtPoint(path.points.front(), false));
    const std::size_t begin = this->Borders.samples.size();
    std::map<int, std::vector<std::pair<double, int>>> onEdge; // of the path
    for (const Path::Place& place : path.divide(steps))
    {
      const Edge& edge = this->Edges[path.edges[place.segment]];
      const bool isAhead = edge.low == path.points[place.segment];
      const long long near = place.t < NearVertex ? path.points[place.segment]
        : place.t > 1. - NearVertex               ? path.points[place.segment + 1]
                                                  : -1;
      if (near >= 0 && this->Borders.atPoint.count(near) == 0)
      {
        curve.samples.push_back(this->addAtPoint(near, false));
        continue;
      }
      BorderSample sample;
      sample.a = edge.low;
      sample.b = edge.high;
      sample.t = std::clamp(isAhead ? place.t : 1. - place.t, 1e-3, 1. - 1e-3);
      sample.position = (1. - sample.t) * edge.xLow + sample.t * edge.xHigh;
      sample.blocks.assign(edge.blocks.begin(), edge.blocks.end());
      const int id = static_cast<int>(this->Borders.samples.size());
      onEdge[path.edges[place.segment]].emplace_back(sample.t, id);
      this->Borders.samples.push_back(sample);
      curve.samples.push_back(id);
    }
    curve.samples.push_back(this->addAtPoint(path.points.back(), false));
    for (std::size_t s = begin; s < this->Borders.samples.size(); ++s)
    {
      this->Borders.samples[s].isHeld = this->Borders.samples[s].isHeld || curve.isCrease;
    }
    for (auto& [e, samples] : onEdge)
    {
      std::sort(samples.begin(), samples.end());
      std::vector<int>& there =
        this->Borders.onEdge[{ { this->Edges[e].low, this->Edges[e].high } }];
      for (const auto& [t, id] : samples)
      {
        there.push_back(id);
      }
    }
    this->Borders.curves.push_back(std::move(curve));
  }

  double Scale;
  BlockBorders& Borders;
  std::vector<Edge> Edges;
  std::map<long long, std::vector<int>> At; // edges, by point
  std::map<long long, std::set<int>> BlocksAt;
  std::set<long long> Nodes; // at features and boundaries
  std::set<long long> IsNode;
};
}

Status sampleBorders(std::vector<OpenEdge> edges, double scale, BlockBorders& borders)
{
  borders = {};
  BorderGraph graph(scale, borders);
  if (Status status = graph.match(std::move(edges)); !status.ok())
  {
    return status;
  }
  graph.sample();
  return Status::success();
}

vtkSmartPointer<vtkPolyData> toPolyData(const BlockBorders& borders)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const BorderSample& sample : borders.samples)
  {
    points->InsertNextPoint(sample.position.data());
  }
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkIntArray> blocks;
  blocks->SetName("BlockIds");
  blocks->SetNumberOfComponents(2);
  for (const BorderCurve& curve : borders.curves)
  {
    lines->InsertNextCell(static_cast<int>(curve.samples.size()));
    for (const int s : curve.samples)
    {
      lines->InsertCellPoint(s);
    }
    blocks->InsertNextTypedTuple(curve.blocks.data());
  }
  result->SetPoints(points);
  result->SetLines(lines);
  result->GetCellData()->AddArray(blocks);
  return result;
}
}
