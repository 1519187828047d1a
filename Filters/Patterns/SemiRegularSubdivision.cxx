// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SemiRegularSubdivision.h"

#include "MeshCreation.h"
#include "MeshOptimizer.h"
#include "SurfaceViews.h"

#include <algorithm>
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

/// The place that walks from one end of an edge reach that come nearest to the middle of the chord.
SurfacePlace middleOf(const Atlas& atlas, const SurfacePlace& from, const SurfacePlace& to)
{
  const AtlasSurface& surface = atlas.surface();
  const Vec3 a = surface.position(from.face, from.bary);
  const Vec3 middle = 0.5 * (a + surface.position(to.face, to.bary));
  SurfacePlace best = from;
  double nearest = 1e300;
  for (const auto& end : { from, to })
  {
    for (const SurfacePlace& start : viewsOf(surface, end, OnEdge))
    {
      SurfacePlace place = start;
      for (int step = 0; step < 4; ++step)
      {
        place = atlas.walk().walk(place, middle - surface.position(place.face, place.bary));
      }
      const double distance = (surface.position(place.face, place.bary) - middle).squaredNorm();
      if (distance < (1. - 1e-9) * nearest)
      {
        nearest = distance;
        best = place;
      }
    }
  }
  return best;
}

/// The edges of the mesh that lie on sharp and boundary backbones, with the arc length of their
/// middles.
std::unordered_map<std::uint64_t, Sample> middlesOnBackbones(
  const Atlas& atlas, const std::vector<Sample>& samples)
{
  std::unordered_map<std::uint64_t, Sample> result;
  const FeatureGraph& graph = atlas.graph();
  const auto chains = backboneChains(graph, samples);
  for (std::size_t b = 0; b < chains.size(); ++b)
  {
    const Backbone& backbone = graph.backbones[b];
    const BackboneTrace& trace = atlas.traces()[b];
    const std::vector<int>& chain = chains[b];
    if (backbone.type == BackboneType::Seam)
    {
      continue;
    }
    for (std::size_t i = 1; i < chain.size(); ++i)
    {
      const Sample& first = samples[chain[i - 1]];
      const Sample& second = samples[chain[i]];
      const bool atBegin = !backbone.closed && i == 1;
      const bool atEnd = !backbone.closed && i + 1 == chain.size();
      const double s = atBegin ? 0. : first.arcLength;
      double t = atEnd ? trace.length() : second.arcLength;
      t += t <= s ? trace.length() : 0.;
      double middle = 0.5 * (s + t);
      middle -= middle >= trace.length() ? trace.length() : 0.;
      Sample sample;
      sample.kind = SampleKind::Backbone;
      sample.backbone = static_cast<int>(b);
      sample.arcLength = middle;
      const SurfacePlace place = atlas.placeOfBackbone(sample.backbone, middle);
      sample.face = place.face;
      sample.bary = place.bary;
      result[edgeKey(chain[i - 1], chain[i])] = sample;
    }
  }
  return result;
}

Status relax(const Atlas& atlas, SubdividedMesh& mesh, int rounds, const Progress& progress)
{
  OptimizedMesh optimized;
  const DensityField uniform;
  Status status = optimized.build(atlas, uniform, mesh.samples, mesh.triangles);
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
  return status;
}

void splitOnce(const Atlas& atlas, int level, SubdividedMesh& mesh)
{
  const auto onBackbones = middlesOnBackbones(atlas, mesh.samples);
  std::unordered_map<std::uint64_t, int> middle;
  const auto middleVertex = [&](int a, int b) {
    const auto [entry, fresh] =
      middle.try_emplace(edgeKey(a, b), static_cast<int>(mesh.samples.size()));
    if (fresh)
    {
      const auto found = onBackbones.find(edgeKey(a, b));
      if (found != onBackbones.end())
      {
        mesh.samples.push_back(found->second);
      }
      else
      {
        const int first = std::min(a, b);
        const int second = std::max(a, b);
        const SurfacePlace place =
          middleOf(atlas, { mesh.samples[first].face, mesh.samples[first].bary },
            { mesh.samples[second].face, mesh.samples[second].bary });
        Sample sample;
        sample.face = place.face;
        sample.bary = place.bary;
        mesh.samples.push_back(sample);
      }
      mesh.level.push_back(level);
      mesh.parents.push_back({ { std::min(a, b), std::max(a, b) } });
    }
    return entry->second;
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
  const std::vector<Triangle>& triangles, int levels, int rounds, SubdividedMesh& mesh,
  const Progress& progress)
{
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
