// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Control images made by hand for the charts of ../Cxx/SyntheticAtlas.h, and what must hold of
// their samples.
#ifndef stipple_testing_SyntheticControl_h
#define stipple_testing_SyntheticControl_h

#include "../Cxx/SyntheticAtlas.h"
#include "InteriorSampling.h"
#include "SurfaceSampler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>

namespace synthetic
{
/// Control = area distortion x importance(position), on images of `size` pixels along the longer
/// side.
struct ControlMaps
{
  std::vector<std::vector<float>> control;
  std::vector<std::vector<float>> area;
  std::vector<std::vector<int>> face;
  std::vector<ControlImage> images;

  ControlMaps(const AtlasSurface& s, int size,
    const std::function<double(const Vec3&)>& importance = nullptr, double slimness = 1.)
    : control(s.numberOfCharts())
    , area(s.numberOfCharts())
    , face(s.numberOfCharts())
  {
    for (int c = 0; c < s.numberOfCharts(); ++c)
    {
      ControlImage image;
      image.extent = s.extent[c];
      image.width = std::max(4, static_cast<int>(size * s.extent[c].x()));
      image.height = std::max(4, static_cast<int>(size / slimness * s.extent[c].y()));
      int f = s.chartBegin[c];
      for (int i = 0; i < image.numberOfPixels(); ++i)
      {
        Vec3 bary;
        locate(s, c, image.centre(i), f, f, bary);
        this->face[c].push_back(f - s.chartBegin[c]);
        this->area[c].push_back(static_cast<float>(s.areaDistortion(f)));
        const double w = importance ? importance(s.position(f, bary)) : 1.;
        this->control[c].push_back(static_cast<float>(w * s.areaDistortion(f)));
      }
      image.control = this->control[c].data();
      image.areaDistortion = this->area[c].data();
      image.faceIndex = this->face[c].data();
      this->images.push_back(image);
    }
  }
  /// Where a pixel of a chart lies on the surface.
  Vec3 position(const AtlasSurface& s, int c, int pixel) const
  {
    const ControlImage& image = this->images[c];
    int f = 0;
    Vec3 bary;
    locate(s, c, image.centre(pixel), s.chartBegin[c] + image.faceIndex[pixel], f, bary);
    return s.position(f, bary);
  }
  ControlMaps(const ControlMaps&) = delete;
  void operator=(const ControlMaps&) = delete;

  /// The control's pixels, by chart.
  std::vector<float*> pixels()
  {
    std::vector<float*> result;
    for (std::vector<float>& chart : this->control)
    {
      result.push_back(chart.data());
    }
    return result;
  }
};

/// By brute force: segments of a chart meet only at shared ends, features and interior samples lie
/// strictly inside the boundary's polygon, off all segments and apart; no two intervals join the
/// same two samples.
inline void expectTriangulable(const SurfaceSamples& result, const SamplingDomain& domain)
{
  std::set<std::array<int, 4>> seen;
  std::set<std::pair<int, int>> edges;
  for (std::size_t c = 0; c < result.graphs.size(); ++c)
  {
    const ChartGraph& g = result.graphs[c];
    const auto uv = [&](int v) { return g.vertices[v].uv; };
    ASSERT_GE(g.boundary.size(), 3u);
    double area = 0;
    for (std::size_t i = 0; i < g.boundary.size(); ++i)
    {
      area += 0.5 * cross2(uv(g.boundary[i]), uv(g.boundary[(i + 1) % g.boundary.size()]));
    }
    ASSERT_GT(area, 0.);
    std::set<int> onBoundary(g.boundary.begin(), g.boundary.end());
    std::vector<Vec2> inside = result.interior[c];
    inside.insert(
      inside.end(), domain.chartConstraints[c].begin(), domain.chartConstraints[c].end());
    for (const ChartGraph::Segment& s : g.segments)
    {
      for (const Vec2& p : inside)
      {
        ASSERT_GT(distanceToSegment(p, uv(s.first), uv(s.second)), 1e-9) << "chart " << c;
      }
      for (std::size_t v = 0; v < g.vertices.size(); ++v)
      {
        const int i = static_cast<int>(v);
        if (i != s.first && i != s.second && !(s.onBoundary && onBoundary.count(i)))
        {
          ASSERT_GT(distanceToSegment(uv(i), uv(s.first), uv(s.second)), 1e-12) << "chart " << c;
        }
      }
      for (const ChartGraph::Segment& o : g.segments)
      {
        const std::set<int> ends = { s.first, s.second, o.first, o.second };
        if (&o == &s || ends.size() < 4)
        {
          continue;
        }
        const bool apart1 = orient2(uv(s.first), uv(s.second), uv(o.first)) *
            orient2(uv(s.first), uv(s.second), uv(o.second)) >=
          0;
        const bool apart2 = orient2(uv(o.first), uv(o.second), uv(s.first)) *
            orient2(uv(o.first), uv(o.second), uv(s.second)) >=
          0;
        ASSERT_TRUE(apart1 || apart2) << "segments cross in chart " << c;
      }
      const int p = g.vertices[s.first].sample;
      const int q = g.vertices[s.second].sample;
      ASSERT_NE(p, q);
      if (seen.insert({ std::min(p, q), std::max(p, q), s.backbone, s.interval }).second)
      {
        ASSERT_TRUE(edges.insert({ std::min(p, q), std::max(p, q) }).second) << "a double edge";
      }
    }
    for (std::size_t v = 0; v < g.vertices.size(); ++v)
    {
      if (!onBoundary.count(static_cast<int>(v)))
      {
        inside.push_back(uv(static_cast<int>(v)));
      }
    }
    ASSERT_TRUE(!inside.empty() || g.boundary.size() > 3) << "three samples and nothing inside";
    for (std::size_t i = 0; i < inside.size(); ++i)
    {
      for (std::size_t k = 0; k < g.boundary.size(); ++k)
      {
        ASSERT_GT(
          orient2(uv(g.boundary[k]), uv(g.boundary[(k + 1) % g.boundary.size()]), inside[i]), 0.)
          << "outside chart " << c;
      }
      for (std::size_t j = 0; j < i; ++j)
      {
        ASSERT_GT((inside[i] - inside[j]).norm(), 1e-9);
      }
    }
  }
}

/// The contract of the samples themselves.
inline void expectOnSurface(const SurfaceSamples& result, const SamplingDomain& domain)
{
  const AtlasSurface& s = domain.surface();
  ASSERT_EQ(result.samples.size(), result.density.size());
  for (const Sample& x : result.samples)
  {
    ASSERT_GE(x.face, 0);
    ASSERT_LT(x.face, s.numberOfFaces());
    ASSERT_GE(x.bary.minCoeff(), 0.);
    ASSERT_NEAR(x.bary.sum(), 1., 1e-12);
    ASSERT_EQ(x.kind == SampleKind::Backbone, x.backbone >= 0);
    ASSERT_EQ(x.kind == SampleKind::Corner, x.surfacePoint >= 0);
  }
  std::size_t i = 0;
  std::size_t interior = 0;
  for (const auto& list : result.interior)
  {
    interior += list.size();
  }
  i = result.samples.size() - interior;
  for (std::size_t c = 0; c < result.interior.size(); ++c)
  {
    for (const Vec2& uv : result.interior[c])
    {
      const Sample& x = result.samples[i++];
      ASSERT_EQ(x.kind, SampleKind::Interior);
      ASSERT_EQ(s.faceChart[x.face], static_cast<int>(c));
      ASSERT_LT((s.parameter(x.face, x.bary) - uv).norm(), 1e-9);
    }
  }
}
}

#endif
