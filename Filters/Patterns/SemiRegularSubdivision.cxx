// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SemiRegularSubdivision.h"

#include "MeshCreation.h"
#include "MeshOptimizer.h"
#include "SurfaceViews.h"
#include "Tuning.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_map>

namespace stipple
{
namespace
{
std::uint64_t edgeKey(int a, int b)
{
  return (static_cast<std::uint64_t>(std::min(a, b)) << 32) |
    static_cast<unsigned int>(std::max(a, b));
}

/// Barycentric coordinate up to which a place is on an edge: rounding, after a walk that ended
/// there.
constexpr double OnEdge = 1e-9;
/// Distance from a backbone, over the length of an edge, up to which a vertex is on it: rounding.
constexpr double OnBackbone = 1e-6;

Sample sampleAt(const SurfacePlace& place)
{
  Sample sample;
  sample.face = place.face;
  sample.bary = place.bary;
  return sample;
}

/// The place that walks from one end of an edge reach that come nearest to the middle of the chord,
/// across creases only where all others end far from it: the edge leads across one.
SurfacePlace middleOf(const Atlas& atlas, const SurfacePlace& from, const SurfacePlace& to)
{
  const AtlasSurface& surface = atlas.surface();
  const Vec3 a = surface.position(from.face, from.bary);
  const Vec3 b = surface.position(to.face, to.bary);
  const Vec3 middle = 0.5 * (a + b);
  const double far = Tuning::FarthestOffEdge * Tuning::FarthestOffEdge * (b - a).squaredNorm();
  SurfacePlace best = from;
  double nearest = 1e300;
  for (const bool passWalls : { false, true })
  {
    for (const auto& end : { from, to })
    {
      for (const SurfacePlace& start : viewsOf(surface, end, OnEdge))
      {
        SurfacePlace place = start;
        for (int step = 0; step < 4; ++step)
        {
          place =
            atlas.walk().walk(place, middle - surface.position(place.face, place.bary), passWalls);
        }
        const double distance = (surface.position(place.face, place.bary) - middle).squaredNorm();
        if (distance < (1. - 1e-9) * nearest)
        {
          nearest = distance;
          best = place;
        }
      }
    }
    if (nearest <= far)
    {
      break;
    }
  }
  return best;
}

/// Of a backbone, from one arc length to another: where it is nearest to a place. A closed one goes
/// on behind its end.
double nearestArcLength(const Atlas& atlas, int backbone, const Vec3& place, double from, double to)
{
  const Backbone& line = atlas.graph().backbones[backbone];
  const BackboneTrace& trace = atlas.traces()[backbone];
  const std::vector<Vec3>& points = atlas.surface().points;
  const int n = line.numberOfSegments();
  double result = from;
  double nearest = 1e300;
  for (int i = 0; i < (line.closed ? 2 * n : n); ++i)
  {
    const double before = i < n ? 0. : trace.length();
    const double begin = before + trace.arcLength[i % n];
    const double length = trace.arcLength[i % n + 1] - trace.arcLength[i % n];
    if (!(length > 0) || begin + length < from || begin > to)
    {
      continue;
    }
    const Vec3& a = points[line.points[i % n]];
    const Vec3 along = points[line.segmentEnd(i % n)] - a;
    const double low = std::max(0., (from - begin) / length);
    const double high = std::max(low, std::min(1., (to - begin) / length));
    const double t = std::clamp((place - a).dot(along) / along.squaredNorm(), low, high);
    const double distance = (a + t * along - place).squaredNorm();
    if (distance < nearest)
    {
      nearest = distance;
      result = begin + t * length;
    }
  }
  return result;
}

/// The vertices of a backbone with where they are along it: those that are not on it are where it
/// is nearest to them, between those that are.
OptimizedMesh::Chain chainOf(
  const Atlas& atlas, int backbone, std::vector<int> ids, const std::vector<Sample>& samples)
{
  OptimizedMesh::Chain chain;
  if (ids.size() < 2)
  {
    return chain;
  }
  const AtlasSurface& surface = atlas.surface();
  const double length = atlas.traces()[backbone].length();
  const bool closed = atlas.graph().backbones[backbone].closed;
  const auto isOnIt = [&](int v) {
    return samples[v].kind == SampleKind::Backbone && samples[v].backbone == backbone;
  };
  if (closed) // begins with one whose place is known
  {
    const auto first = std::find_if(ids.begin(), ids.end() - 1, isOnIt);
    std::rotate(ids.begin(), first == ids.end() - 1 ? ids.begin() : first, ids.end() - 1);
    ids.back() = ids.front();
  }
  const auto position = [&](int v) { return surface.position(samples[v].face, samples[v].bary); };
  std::vector<double> at(ids.size(), -1.); // below 0: not known
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    at[i] = isOnIt(ids[i]) ? samples[ids[i]].arcLength : -1.;
  }
  at.front() = !closed ? 0.
    : at.front() >= 0  ? at.front()
                       : nearestArcLength(atlas, backbone, position(ids.front()), 0., length);
  at.back() = at.front() + length;
  for (std::size_t i = 1; i + 1 < ids.size(); ++i)
  {
    at[i] += at[i] >= 0 && at[i] < at.front() ? length : 0.;
  }
  for (std::size_t i = 1; i + 1 < ids.size(); ++i)
  {
    if (at[i] < 0)
    {
      const double next = *std::find_if(
        at.begin() + static_cast<std::ptrdiff_t>(i), at.end(), [](double s) { return s >= 0; });
      at[i] = nearestArcLength(atlas, backbone, position(ids[i]), at[i - 1], next);
    }
  }
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    chain.push_back({ Vertex(ids[i]), closed && at[i] >= length ? at[i] - length : at[i] });
  }
  return chain;
}

Status relax(const Atlas& atlas, SubdividedMesh& mesh, int rounds, const Progress& progress)
{
  OptimizedMesh optimized;
  const DensityField uniform;
  const auto held = static_cast<int>(std::count(mesh.level.begin(), mesh.level.end(), 0));
  Status status = optimized.build(atlas, uniform, mesh.samples, mesh.triangles, mesh.chains, held);
  if (!status.ok())
  {
    return status;
  }
  OptimizerOptions options;
  options.swaps = OptimizerOptions::Swaps::None;
  options.moves = OptimizerOptions::Moves::Lloyd;
  options.iterations = rounds;
  options.errorReduction = 0;
  status = optimizeMesh(optimized, options, progress);
  mesh.samples = optimized.samples();
  mesh.chains = optimized.chains();
  for (OptimizedMesh::Chain& chain : mesh.chains)
  {
    for (BackboneVertex& v : chain)
    {
      v.arcLength = optimized.arcLength(v);
    }
  }
  return status;
}

/// The middle of a piece of a backbone: on it, if both its ends are. Where features were
/// simplified, the edge leads from one to another, and each on its own would make a saw of it.
Sample middleOnBackbone(const Atlas& atlas, int backbone, double arcLength, double piece,
  const std::array<SurfacePlace, 2>& ends, const std::array<double, 2>& arcLengths)
{
  const AtlasSurface& surface = atlas.surface();
  const auto isOnIt = [&](int k) {
    const SurfacePlace there = atlas.placeOfBackbone(backbone, arcLengths[k]);
    return (surface.position(ends[k].face, ends[k].bary) - surface.position(there.face, there.bary))
             .norm() <= OnBackbone * piece;
  };
  if (!isOnIt(0) || !isOnIt(1))
  {
    return sampleAt(middleOf(atlas, ends[0], ends[1]));
  }
  Sample sample = sampleAt(atlas.placeOfBackbone(backbone, arcLength));
  sample.kind = SampleKind::Backbone;
  sample.backbone = backbone;
  sample.arcLength = arcLength;
  return sample;
}

/// Edges by their ends, and the vertices that split them.
class Splits
{
public:
  Splits(SubdividedMesh& mesh, int level)
    : Mesh(mesh)
    , Level(level)
  {
  }
  /// The vertex of an edge: made, if it is the first time, of what sample() says.
  template <typename MakeSample>
  int vertexOf(int a, int b, const MakeSample& sample)
  {
    const auto [entry, isNew] =
      this->Middle.try_emplace(edgeKey(a, b), static_cast<int>(this->Mesh.samples.size()));
    if (isNew)
    {
      this->Mesh.samples.push_back(sample());
      this->Mesh.level.push_back(this->Level);
      this->Mesh.parents.push_back({ { std::min(a, b), std::max(a, b) } });
    }
    return entry->second;
  }

private:
  SubdividedMesh& Mesh;
  const int Level;
  std::unordered_map<std::uint64_t, int> Middle;
};

void splitChains(const Atlas& atlas, Splits& splits, SubdividedMesh& mesh)
{
  for (std::size_t b = 0; b < mesh.chains.size(); ++b)
  {
    const OptimizedMesh::Chain coarse = std::move(mesh.chains[b]);
    OptimizedMesh::Chain& chain = mesh.chains[b];
    chain.clear();
    const bool isClosed = atlas.graph().backbones[b].closed;
    const double length = atlas.traces()[b].length();
    for (std::size_t i = 0; i < coarse.size(); ++i)
    {
      if (i > 0)
      {
        const BackboneVertex& from = coarse[i - 1];
        const BackboneVertex& to = coarse[i];
        const bool wraps = isClosed && to.arcLength <= from.arcLength;
        const double piece = to.arcLength - from.arcLength + (wraps ? length : 0.);
        double middle = from.arcLength + 0.5 * piece;
        middle -= isClosed && middle >= length ? length : 0.;
        const int v = splits.vertexOf(from.vertex.index(), to.vertex.index(), [&]() {
          const Sample& first = mesh.samples[from.vertex.index()];
          const Sample& second = mesh.samples[to.vertex.index()];
          return middleOnBackbone(atlas, static_cast<int>(b), middle, piece,
            { { { first.face, first.bary }, { second.face, second.bary } } },
            { { from.arcLength, to.arcLength } });
        });
        chain.push_back({ Vertex(v), middle });
      }
      chain.push_back(coarse[i]);
    }
  }
}

void splitOnce(const Atlas& atlas, int level, SubdividedMesh& mesh)
{
  Splits splits(mesh, level);
  splitChains(atlas, splits, mesh);
  const auto middleVertex = [&](int a, int b) {
    return splits.vertexOf(a, b, [&]() {
      const Sample& first = mesh.samples[std::min(a, b)];
      const Sample& second = mesh.samples[std::max(a, b)];
      return sampleAt(middleOf(atlas, { first.face, first.bary }, { second.face, second.bary }));
    });
  };
  std::vector<Triangle> triangles;
  std::vector<int> base;
  triangles.reserve(4 * mesh.triangles.size());
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
  {
    const Triangle t = mesh.triangles[f];
    const int p = middleVertex(t[0], t[1]);
    const int q = middleVertex(t[1], t[2]);
    const int r = middleVertex(t[2], t[0]);
    for (const Triangle& child : { Triangle{ t[0], p, r }, Triangle{ p, t[1], q },
           Triangle{ r, q, t[2] }, Triangle{ p, q, r } })
    {
      triangles.push_back(child);
      base.push_back(mesh.baseTriangle[f]);
    }
  }
  mesh.triangles = std::move(triangles);
  mesh.baseTriangle = std::move(base);
}
}

Status subdivideSemiRegularly(const Atlas& atlas, const std::vector<Sample>& samples,
  const std::vector<Triangle>& triangles, const std::vector<std::vector<int>>& chains, int levels,
  int rounds, SubdividedMesh& mesh, const Progress& progress)
{
  mesh.chains.clear();
  for (std::size_t b = 0; b < chains.size(); ++b)
  {
    const bool isSeam = atlas.graph().backbones[b].type == BackboneType::Seam;
    mesh.chains.push_back(
      isSeam ? OptimizedMesh::Chain() : chainOf(atlas, static_cast<int>(b), chains[b], samples));
  }
  mesh.samples = samples;
  mesh.triangles = triangles;
  mesh.level.assign(samples.size(), 0);
  mesh.parents.assign(samples.size(), { { -1, -1 } });
  mesh.baseTriangle.resize(triangles.size());
  for (std::size_t f = 0; f < triangles.size(); ++f)
  {
    mesh.baseTriangle[f] = static_cast<int>(f);
  }
  for (int level = 1; level <= levels; ++level)
  {
    const auto part = [&](double done) { return report(progress, (level - 1 + done) / levels); };
    if (!part(0.))
    {
      return Status::aborted();
    }
    splitOnce(atlas, level, mesh);
    if (rounds > 0)
    {
      Status status = relax(atlas, mesh, rounds, part);
      if (!status.ok())
      {
        return status;
      }
    }
  }
  return Status::success();
}
}
