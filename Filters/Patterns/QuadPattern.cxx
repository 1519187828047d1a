// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "QuadPattern.h"

#include "GradedLattice.h"
#include "MeshCreation.h"
#include "MeshOptimizer.h"
#include "OptimizedMesh.h"
#include "SurfaceViews.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <unordered_map>

namespace stipple
{
namespace
{
using Segment = std::array<Vec2, 2>;

/// By node, whether it is half its spacing and more from the rectangle's sides and all segments.
std::vector<char> clearNodes(
  const GradedLattice& lattice, const Vec2& extent, const std::vector<Segment>& segments)
{
  constexpr double Clearance = 0.5; // in spacings
  const std::size_t n = lattice.nodes.size();
  std::vector<char> clear(n, 0);
  double most = 0;
  for (std::size_t i = 0; i < n; ++i)
  {
    const Vec2& p = lattice.nodes[i];
    const double margin = Clearance * lattice.spacing[i];
    clear[i] = p.minCoeff() >= margin && (extent - p).minCoeff() >= margin;
    most = std::max(most, margin);
  }
  if (segments.empty())
  {
    return clear;
  }
  const PointBins bins(lattice.nodes);
  const Vec2 reach(most, most);
  for (const Segment& s : segments)
  {
    bins.forEachIn(s[0].cwiseMin(s[1]) - reach, s[0].cwiseMax(s[1]) + reach, [&](int i) {
      if (distanceToSegment(lattice.nodes[i], s[0], s[1]) < Clearance * lattice.spacing[i])
      {
        clear[i] = 0;
      }
    });
  }
  return clear;
}

/// The place on the surface of every node in a chart's plane; face -1 where there is none.
std::vector<SurfacePlace> placesOf(
  const AtlasSurface& surface, int chart, const std::vector<Vec2>& nodes)
{
  constexpr double Tolerance = 1e-9;
  const PointBins bins(nodes);
  std::vector<SurfacePlace> places(nodes.size());
  std::vector<double> inside(nodes.size(), -Tolerance);
  for (int f = surface.chartBegin[chart]; f < surface.chartBegin[chart + 1]; ++f)
  {
    const Vec2& a = surface.cornerUV(f, 0);
    const Vec2& b = surface.cornerUV(f, 1);
    const Vec2& c = surface.cornerUV(f, 2);
    if (orient2(a, b, c) <= 0)
    {
      continue;
    }
    const Vec2 margin(Tolerance, Tolerance);
    bins.forEachIn(
      a.cwiseMin(b).cwiseMin(c) - margin, a.cwiseMax(b).cwiseMax(c) + margin, [&](int n) {
        const Vec3 bary = barycentric(nodes[n], a, b, c);
        if (bary.minCoeff() > inside[n]) // the deepest wins: on edges, whatever the order of faces
        {
          inside[n] = bary.minCoeff();
          places[n] = { f, clampedBarycentric(bary) };
        }
      });
  }
  return places;
}

Sample interiorSample(const SurfacePlace& place)
{
  Sample sample;
  sample.face = place.face;
  sample.bary = place.bary;
  return sample;
}

/// A sample on the outline: a corner if a node of the graph is there, else on its backbone.
class OutlineSamples
{
public:
  explicit OutlineSamples(const stipple::Atlas& atlas)
    : Surface(atlas.surface())
    , Atlas(atlas)
    , IsNode(atlas.surface().points.size(), 0)
  {
    for (int p : atlas.graph().nodes())
    {
      this->IsNode[p] = 1;
    }
    for (std::size_t b = 0; b < atlas.traces().size(); ++b)
    {
      for (int side = 0; side < 2; ++side)
      {
        const auto& halfedges = atlas.traces()[b].halfedge[side];
        for (std::size_t s = 0; s < halfedges.size(); ++s)
        {
          this->PieceOf[halfedges[s]] = { { static_cast<int>(b), static_cast<int>(s), side } };
        }
      }
    }
  }
  Sample at(const SurfacePlace& place) const
  {
    constexpr double OnPoint = 1e-9;
    Sample sample = interiorSample(place);
    for (int k = 0; k < 3; ++k)
    {
      const int p = this->Surface.triangles[place.face][k];
      if (place.bary[k] > 1. - OnPoint && this->IsNode[p])
      {
        sample.kind = SampleKind::Corner;
        sample.surfacePoint = p;
        sample.bary = Vec3::Unit(k);
        return sample;
      }
    }
    double nearest = 1e300;
    // At a point of the outline, the place's face may have no edge of it.
    for (const SurfacePlace& view : viewsOf(this->Surface, place, OnPoint))
    {
      for (const Halfedge h : halfedgesOf(Face(view.face)))
      {
        const auto found = this->PieceOf.find(h.index());
        const double away = view.bary[cornerOf(previousHalfedge(h))];
        if (found == this->PieceOf.end() || away >= nearest)
        {
          continue;
        }
        nearest = away;
        const auto& [b, segment, side] = found->second;
        const std::vector<double>& arc = this->Atlas.traces()[b].arcLength;
        const double head = view.bary[cornerOf(nextHalfedge(h))];
        const double t = head / std::max(1e-300, head + view.bary[cornerOf(h)]);
        sample.kind = SampleKind::Backbone;
        sample.face = view.face;
        sample.bary = view.bary;
        sample.backbone = b;
        sample.arcLength =
          arc[segment] + (side == 0 ? t : 1. - t) * (arc[segment + 1] - arc[segment]);
      }
      if (nearest <= OnPoint)
      {
        break;
      }
    }
    return sample;
  }

private:
  const AtlasSurface& Surface;
  const stipple::Atlas& Atlas;
  std::vector<char> IsNode;
  std::unordered_map<int, std::array<int, 3>> PieceOf; // by halfedge: backbone, segment, side
};

/// One chart that only its outline bounds.
bool isOneOpenChart(const stipple::Atlas& atlas)
{
  const auto& backbones = atlas.graph().backbones;
  return atlas.surface().numberOfCharts() == 1 && atlas.graph().constraints.empty() &&
    std::all_of(backbones.begin(), backbones.end(),
      [](const Backbone& b) { return b.type == BackboneType::Boundary; });
}

/// A grid over its rectangle.
Status gridOfOneChart(const stipple::Atlas& atlas, int numberOfSamples, LatticeSamples& grid)
{
  const AtlasSurface& surface = atlas.surface();
  const Vec2& extent = surface.extent[0];
  // Cells as square as possible, and as many nodes as possible.
  int width = 0;
  int height = 0;
  double best = 1e300;
  for (int w = 2; 2 * w <= numberOfSamples; ++w)
  {
    const int h = numberOfSamples / w;
    const double aspect = std::abs(std::log(extent.x() / (w - 1) / (extent.y() / (h - 1))));
    const double missing = static_cast<double>(numberOfSamples - w * h) / numberOfSamples;
    if (aspect + 4. * missing < best)
    {
      best = aspect + 4. * missing;
      width = w;
      height = h;
    }
  }
  if (width == 0)
  {
    return Status::tooFewPoints("A grid of quads needs at least 4 points.", 4);
  }
  const Vec2 spacing = extent.cwiseQuotient(Vec2(width - 1, height - 1));
  std::vector<Vec2> nodes;
  for (int j = 0; j < height; ++j)
  {
    for (int i = 0; i < width; ++i)
    {
      nodes.emplace_back(spacing.cwiseProduct(Vec2(i, j)));
    }
  }
  const OutlineSamples outline(atlas);
  const std::vector<SurfacePlace> places = placesOf(surface, 0, nodes);
  for (int j = 0; j < height; ++j)
  {
    for (int i = 0; i < width; ++i)
    {
      const SurfacePlace& place = places[j * width + i];
      if (place.face < 0)
      {
        return Status::error("The parameters of chart 0 do not cover its rectangle: pass the "
                             "output of vtkConformalAtlas.");
      }
      const bool onOutline = i == 0 || j == 0 || i == width - 1 || j == height - 1;
      grid.samples.push_back(onOutline ? outline.at(place) : interiorSample(place));
      if (i > 0 && j > 0)
      {
        const int n = j * width + i;
        grid.cells.push_back({ { n - width - 1, n - width, n, n - 1 } });
      }
    }
  }
  return Status::success();
}

/// Puts the outline's nodes nearest to its corners there. False if two are for one corner's.
bool snapToCorners(const stipple::Atlas& atlas, LatticeSamples& grid)
{
  const AtlasSurface& surface = atlas.surface();
  std::vector<std::size_t> outline;
  for (std::size_t i = 0; i < grid.samples.size(); ++i)
  {
    if (grid.samples[i].kind != SampleKind::Interior)
    {
      outline.push_back(i);
    }
  }
  std::set<std::size_t> taken;
  for (int p = 0; p < static_cast<int>(atlas.graph().isCorner.size()); ++p)
  {
    if (atlas.graph().isCorner[p] == 0)
    {
      continue;
    }
    const auto distance = [&](std::size_t i) {
      const Sample& s = grid.samples[i];
      return (surface.position(s.face, s.bary) - surface.points[p]).squaredNorm();
    };
    const auto nearest = std::min_element(outline.begin(), outline.end(),
      [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
    if (nearest == outline.end() || !taken.insert(*nearest).second)
    {
      return false;
    }
    const SurfacePlace place = atlas.placeOfPoint(p);
    Sample corner = interiorSample(place);
    corner.kind = SampleKind::Corner;
    corner.surfacePoint = p;
    grid.samples[*nearest] = corner;
  }
  return true;
}

/// Inner backbones of every chart in its parameter plane.
std::vector<std::vector<Segment>> innerSegments(const stipple::Atlas& atlas)
{
  const AtlasSurface& surface = atlas.surface();
  std::vector<std::vector<Segment>> segments(surface.numberOfCharts());
  for (const BackboneTrace& trace : atlas.traces())
  {
    for (int side = 0; side < 2; ++side)
    {
      for (int h : trace.halfedge[side])
      {
        if (h >= 0)
        {
          segments[surface.faceChart[faceOf(Halfedge(h)).index()]].push_back(
            { { surface.uv[h], surface.uv[nextHalfedge(h)] } });
        }
      }
    }
  }
  return segments;
}

/// The lattice of a chart with the smallest cells at most `count` nodes of which are half a spacing
/// clear of backbones and of `fixed` points, give or take what farthest samples make up for.
GradedLattice latticeOfChart(const AtlasSurface& surface, int chart, std::vector<Segment> segments,
  const std::vector<Vec2>& fixed, int count, const DensityField& density, std::vector<char>& clear)
{
  constexpr int MostSteps = 20;
  constexpr int Grains = 16; // of area a cell
  const int enough = count - count / 500;
  const AreaPoints area = spreadArea(surface, chart, Grains * (count + 1.), density);
  for (const Vec2& p : fixed)
  {
    segments.push_back({ { p, p } });
  }
  GradedLattice lattice;
  const auto nodesOf = [&](double wanted) {
    lattice = gradedLattice(area, wanted);
    clear = clearNodes(lattice, area.extent, segments);
    return static_cast<int>(std::count(clear.begin(), clear.end(), 1));
  };
  // There are as many nodes as cells, about: the next try is by that, or else between those before.
  double coarse = 1e300; // fits
  double fine = 0;       // does not
  double wanted = area.total / (count + 1.);
  for (int step = 0; step < MostSteps; ++step)
  {
    const int n = nodesOf(wanted);
    (n <= count ? coarse : fine) = wanted;
    if (n >= enough && n <= count)
    {
      return lattice;
    }
    const double guess = wanted * (n + 1.) / (0.5 * (count + enough) + 1.);
    wanted = guess > fine && guess < coarse ? guess : std::sqrt(fine * coarse);
  }
  if (coarse > area.total || nodesOf(coarse) > count) // nothing fits
  {
    std::fill(clear.begin(), clear.end(), 0);
  }
  return lattice;
}

/// Adds `missing` of the candidates, each time the one farthest from all that is there.
void addFarthest(const AtlasSurface& surface, const std::vector<Sample>& samples,
  const std::vector<int>& candidates, const std::vector<Vec2>& present, int missing,
  std::vector<Sample>& result)
{
  if (missing <= 0)
  {
    return;
  }
  const PointBins there(present);
  std::vector<Vec2> place;
  std::vector<double> distance;
  for (int s : candidates)
  {
    place.push_back(surface.parameter(samples[s].face, samples[s].bary));
    distance.push_back(there.squaredDistance(place.back()));
  }
  const auto account = [&](const Vec2& p) {
    for (std::size_t i = 0; i < place.size(); ++i)
    {
      distance[i] = std::min(distance[i], (place[i] - p).squaredNorm());
    }
  };
  for (int k = 0; k < missing; ++k)
  {
    const auto i = static_cast<std::size_t>(
      std::max_element(distance.begin(), distance.end()) - distance.begin());
    result.push_back(samples[candidates[i]]);
    account(place[i]);
    distance[i] = -1.;
  }
}

std::array<Vec3, 4> cornersOf(
  const AtlasSurface& surface, const std::vector<Sample>& samples, const std::array<int, 4>& cell)
{
  std::array<Vec3, 4> corners;
  for (std::size_t i = 0; i < 4; ++i)
  {
    const Sample& s = samples[static_cast<std::size_t>(cell[i])];
    corners[i] = surface.position(s.face, s.bary);
  }
  return corners;
}

std::array<double, 4> anglesOf(const std::array<Vec3, 4>& corners)
{
  std::array<double, 4> angles;
  for (std::size_t i = 0; i < 4; ++i)
  {
    const Vec3 next = corners[(i + 1) % 4] - corners[i];
    const Vec3 last = corners[(i + 3) % 4] - corners[i];
    angles[i] = std::atan2(next.cross(last).norm(), next.dot(last));
  }
  return angles;
}

bool isAboutSquare(const std::array<Vec3, 4>& corners)
{
  constexpr double MostOff = 0.25 * Pi; // halfway to where three corners are on a line
  const std::array<double, 4> angles = anglesOf(corners);
  return std::all_of(angles.begin(), angles.end(),
    [](double angle) { return std::abs(angle - 0.5 * Pi) <= MostOff; });
}

/// Times that a cell's area may be that which is wanted, or the other way round: twice as far off
/// as the lattice's halves.
constexpr double MostTimes = 4;

/// Half the product of its diagonals.
double areaOf(const std::array<Vec3, 4>& corners)
{
  return 0.5 * (corners[2] - corners[0]).cross(corners[3] - corners[1]).norm();
}

/// A grid's quads, if they are alike in area, and about square but for those at the rectangle's
/// corners: where the outline is smooth there, two sides of a cell are one line, and it becomes two
/// triangles. Else none.
std::vector<std::vector<int>> polygonsOfGrid(
  const AtlasSurface& surface, const LatticeSamples& grid)
{
  std::vector<int> cellsAt(grid.samples.size(), 0);
  for (const std::array<int, 4>& cell : grid.cells)
  {
    for (const int corner : cell)
    {
      ++cellsAt[static_cast<std::size_t>(corner)];
    }
  }
  double mean = 0;
  for (const std::array<int, 4>& cell : grid.cells)
  {
    mean += areaOf(cornersOf(surface, grid.samples, cell)) / static_cast<double>(grid.cells.size());
  }
  std::vector<std::vector<int>> polygons;
  for (const std::array<int, 4>& cell : grid.cells)
  {
    const auto [a, b, c, d] = cell;
    const std::array<Vec3, 4> at = cornersOf(surface, grid.samples, cell);
    if (areaOf(at) > MostTimes * mean) // a hill that the map makes small
    {
      return {};
    }
    if (isAboutSquare(at))
    {
      polygons.push_back({ a, b, c, d });
      continue;
    }
    if (std::min({ cellsAt[a], cellsAt[b], cellsAt[c], cellsAt[d] }) > 1)
    {
      return {};
    }
    const std::array<double, 4> angles = anglesOf(at);
    const bool first = std::max(angles[0], angles[2]) > std::max(angles[1], angles[3]);
    polygons.push_back(first ? std::vector<int>{ a, b, c } : std::vector<int>{ b, c, d });
    polygons.push_back(first ? std::vector<int>{ a, c, d } : std::vector<int>{ a, b, d });
  }
  return polygons;
}

/// Which cells are quads: those that are about square on the surface, and about as large as wanted.
class Squares
{
public:
  Squares(const AtlasSurface& surface, const DensityField& density, std::size_t numberOfSamples)
    : Surface(surface)
    , Density(density)
  {
    for (const Face f : surface.faces())
    {
      this->Wanted += surface.faceArea(f) * this->densityAt({ f.index(), Vec3(1, 1, 1) / 3 });
    }
    this->Wanted /= static_cast<double>(std::max<std::size_t>(1, numberOfSamples));
  }

  bool has(const std::vector<Sample>& samples, const std::array<int, 4>& cell) const
  {
    if (*std::min_element(cell.begin(), cell.end()) < 0)
    {
      return false;
    }
    const std::array<Vec3, 4> corners = cornersOf(this->Surface, samples, cell);
    const double area = areaOf(corners);
    const Sample& first = samples[static_cast<std::size_t>(cell[0])];
    const double amount = area * this->densityAt({ first.face, first.bary });
    return amount * MostTimes > this->Wanted && amount < MostTimes * this->Wanted &&
      isAboutSquare(corners);
  }

private:
  double densityAt(const SurfacePlace& place) const
  {
    return this->Density.uniform() ? 1. : this->Density.at(this->Surface, place);
  }
  const AtlasSurface& Surface;
  const DensityField& Density;
  double Wanted = 0; ///< area, times density, of a sample
};

/// What is between squares is optimised like any mesh of triangles: seams are not seen any more,
/// and no triangle is flat that was Delaunay in a chart's plane. Corners of squares stay.
Status relaxBetween(const stipple::Atlas& atlas, const DensityField& density,
  const Squares& squares, const LatticeSamples& placed, double featureTolerance,
  std::vector<Triangle>& triangles, QuadMesh& quads, const Progress& progress)
{
  std::vector<Sample> fixed = placed.samples;
  for (const std::array<int, 4>& cell : placed.cells)
  {
    if (squares.has(placed.samples, cell))
    {
      for (const int corner : cell)
      {
        fixed[static_cast<std::size_t>(corner)].kind = SampleKind::Constraint;
      }
    }
  }
  OptimizedMesh mesh;
  OptimizerOptions options;
  options.swaps = OptimizerOptions::Swaps::Regularity;
  options.featureTolerance = featureTolerance;
  Status status = mesh.build(atlas, density, fixed, triangles, true);
  status = status.ok() ? optimizeMesh(mesh, options, progress) : status;
  if (!status.ok())
  {
    return status;
  }
  quads.samples = mesh.samples();
  for (std::size_t i = 0; i < fixed.size(); ++i)
  {
    const bool isFixed = fixed[i].kind == SampleKind::Constraint;
    quads.samples[i].kind = isFixed ? placed.samples[i].kind : quads.samples[i].kind;
  }
  triangles = mesh.triangles();
  quads.chains = idsOf(mesh.chains());
  quads.numberOfSimplifiedFeatures = mesh.numberOfSimplifiedFeatures();
  return status;
}
}

Status placeOnLattices(const stipple::Atlas& atlas, const std::vector<Sample>& samples,
  LatticeSamples& result, const Progress& progress, const DensityField& density)
{
  result = {};
  const AtlasSurface& surface = atlas.surface();
  const int charts = surface.numberOfCharts();
  std::vector<std::vector<int>> interior(charts);
  std::vector<std::vector<Vec2>> fixed(charts);
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const Sample& s = samples[i];
    if (s.kind == SampleKind::Interior)
    {
      interior[surface.faceChart[s.face]].push_back(static_cast<int>(i));
      continue;
    }
    result.samples.push_back(s);
    if (s.kind == SampleKind::Constraint)
    {
      fixed[surface.faceChart[s.face]].push_back(surface.parameter(s.face, s.bary));
    }
  }
  const auto segments = innerSegments(atlas);
  for (int c = 0; c < charts; ++c)
  {
    if (!report(progress, static_cast<double>(c) / charts))
    {
      return Status::aborted();
    }
    const int count = static_cast<int>(interior[c].size());
    if (count == 0)
    {
      continue;
    }
    std::vector<char> clear;
    const GradedLattice lattice =
      latticeOfChart(surface, c, segments[c], fixed[c], count, density, clear);
    const std::vector<SurfacePlace> places = placesOf(surface, c, lattice.nodes);
    std::vector<int> sampleOf(lattice.nodes.size(), -1);
    std::vector<Vec2> present = fixed[c];
    int added = 0;
    for (std::size_t n = 0; n < lattice.nodes.size(); ++n)
    {
      if (clear[n] && places[n].face >= 0)
      {
        sampleOf[n] = static_cast<int>(result.samples.size());
        result.samples.push_back(interiorSample(places[n]));
        present.push_back(lattice.nodes[n]);
        ++added;
      }
    }
    for (const auto& cell : lattice.cells)
    {
      result.cells.push_back(
        { { sampleOf[cell[0]], sampleOf[cell[1]], sampleOf[cell[2]], sampleOf[cell[3]] } });
    }
    addFarthest(surface, samples, interior[c], present, count - added, result.samples);
  }
  return Status::success();
}

Status meshWithQuads(const stipple::Atlas& atlas, const std::vector<Sample>& samples,
  QuadMesh& mesh, const Progress& progress, const DensityField& density, double featureTolerance)
{
  mesh = {};
  if (isOneOpenChart(atlas) && density.uniform())
  {
    LatticeSamples grid;
    const Status status = gridOfOneChart(atlas, static_cast<int>(samples.size()), grid);
    if (status.ok() && snapToCorners(atlas, grid))
    {
      mesh.polygons = polygonsOfGrid(atlas.surface(), grid);
    }
    if (!status.ok() || !mesh.polygons.empty())
    {
      mesh.samples = std::move(grid.samples);
      mesh.chains = backboneChains(atlas.graph(), mesh.samples);
      return status;
    }
  }
  const auto part = [&progress](double from, double to) {
    return [&progress, from, to](
             double fraction) { return report(progress, from + fraction * (to - from)); };
  };
  LatticeSamples placed;
  Status status = placeOnLattices(atlas, samples, placed, part(0., 0.4), density);
  std::vector<Triangle> triangles;
  if (status.ok())
  {
    status = createMesh(atlas, placed.samples, triangles, part(0.4, 0.6));
  }
  const Squares squares(atlas.surface(), density, samples.size());
  if (status.ok())
  {
    status = relaxBetween(
      atlas, density, squares, placed, featureTolerance, triangles, mesh, part(0.6, 1.));
  }
  if (!status.ok())
  {
    return status;
  }
  // Two triangles that fill a square become a quad; where samples were moved around one another the
  // cell may lie on its back, and is none.
  const auto fromLeast = [](Triangle t) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return t;
  };
  std::map<Triangle, int> find;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    find[fromLeast(triangles[t])] = static_cast<int>(t);
  }
  std::set<std::pair<int, int>> edges;
  for (const Triangle& t : triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
    }
  }
  const auto triangleOf = [&](int a, int b, int c) {
    const auto found = find.find(fromLeast({ a, b, c }));
    return found == find.end() ? -1 : found->second;
  };
  std::vector<char> used(triangles.size(), 0);
  for (const auto& q : placed.cells)
  {
    if (!squares.has(mesh.samples, q))
    {
      continue;
    }
    for (int diagonal = 0; diagonal < 2; ++diagonal)
    {
      const int s = triangleOf(q[diagonal], q[diagonal + 1], q[diagonal + 2]);
      const int t = triangleOf(q[diagonal], q[diagonal + 2], q[(diagonal + 3) % 4]);
      // However it is cut again, by the other diagonal, too, the mesh is a manifold: about a thin
      // tube that may be an edge on the other side.
      const auto other = std::minmax(q[1 - diagonal], q[3 - diagonal]);
      if (s >= 0 && t >= 0 && edges.insert(other).second)
      {
        used[s] = used[t] = 1;
        mesh.polygons.push_back({ q[0], q[1], q[2], q[3] });
        break;
      }
    }
  }
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    if (!used[t])
    {
      mesh.polygons.push_back({ triangles[t][0], triangles[t][1], triangles[t][2] });
    }
  }
  return Status::success();
}
}
