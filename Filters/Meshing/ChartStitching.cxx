// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ChartStitching.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <unordered_map>

namespace stipple
{
namespace
{
/// Height over longest edge below which a triangle counts as degenerate.
constexpr double MinimumHeight = 1e-6;

class Stitcher
{
public:
  /// isSeam by label.
  Stitcher(const std::vector<ChartTriangulation>& charts, std::vector<Vec3> positions,
    std::vector<char> isSeam);
  std::vector<char> labelsWithEdge();
  bool resolveRepeatedEdges();
  void resolveDegenerateTriangles();
  TriangleComplex& mesh() { return this->Mesh; }
  int sample(int vertex) const { return this->SampleOf[vertex]; }
  int chartOfUnresolvedEdge() const { return this->FaceChart[this->Unresolved / 3]; }

private:
  static std::uint64_t key(int a, int b)
  {
    return (static_cast<std::uint64_t>(std::min(a, b)) << 32) |
      static_cast<unsigned int>(std::max(a, b));
  }
  std::uint64_t edgeKey(int h) const
  {
    return key(this->SampleOf[this->Mesh.tail(h)], this->SampleOf[this->Mesh.head(h)]);
  }
  bool isBad(int h) const
  {
    const std::uint64_t k = this->edgeKey(h);
    return (k >> 32) == (k & 0xffffffffu) || this->Count.at(k) > 1;
  }
  bool canFlip(int h) const
  {
    const int label = this->Mesh.label[h];
    return this->Mesh.twin[h] >= 0 && (label < 0 || (this->SeamsMayGo && this->IsSeam[label]));
  }
  int rootOf(int label)
  {
    while (this->Root[label] != label)
    {
      label = this->Root[label] = this->Root[this->Root[label]];
    }
    return label;
  }
  /// The flip of h yields an edge that is not there yet.
  bool flipIsSimple(int h) const
  {
    const int c = this->SampleOf[this->Mesh.apex(h)];
    const int d = this->SampleOf[this->Mesh.apex(this->Mesh.twin[h])];
    const auto found = this->Count.find(key(c, d));
    return c != d && (found == this->Count.end() || found->second == 0);
  }
  bool isConvex(int h) const;
  void flip(int h)
  {
    --this->Count[this->edgeKey(h)];
    this->Mesh.label[h] = this->Mesh.label[this->Mesh.twin[h]] = -1;
    this->Mesh.flip(h);
    ++this->Count[this->edgeKey(h)];
  }
  double height(int a, int b, int c) const;
  double worstHeight(int h) const;
  double worstHeightAfter(int h) const;
  bool tryBadEdge(int h, bool onlyConvex);

  TriangleComplex Mesh;
  std::vector<int> SampleOf;
  std::vector<Vec2> Parameter;
  std::vector<Vec3> Position; // by sample
  std::vector<int> FaceChart;
  std::unordered_map<std::uint64_t, int> Count; // edges between two samples
  std::vector<char> IsSeam;
  std::vector<int> Root; // of merged labels
  bool SeamsMayGo = false;
  int Unresolved = -1;
};

Stitcher::Stitcher(const std::vector<ChartTriangulation>& charts, std::vector<Vec3> positions,
  std::vector<char> isSeam)
  : Position(std::move(positions))
  , IsSeam(std::move(isSeam))
  , Root(this->IsSeam.size())
{
  std::iota(this->Root.begin(), this->Root.end(), 0);
  for (const ChartTriangulation& chart : charts)
  {
    for (const auto& pair : chart.merged)
    {
      // What is no seam stands for both.
      const int a = this->rootOf(pair[0]);
      const int b = this->rootOf(pair[1]);
      const bool keepA = this->IsSeam[a] == this->IsSeam[b] ? a < b : !this->IsSeam[a];
      this->Root[keepA ? b : a] = keepA ? a : b;
    }
  }
  std::unordered_map<int, int> waiting; // by label, the boundary halfedge whose other side is still
                                        // to come
  for (std::size_t c = 0; c < charts.size(); ++c)
  {
    const TriangleComplex& chart = charts[c].complex;
    const int firstVertex = static_cast<int>(this->SampleOf.size());
    const int firstHalfedge = this->Mesh.numberOfHalfedges();
    for (std::size_t v = 0; v < charts[c].sample.size(); ++v)
    {
      this->SampleOf.push_back(charts[c].sample[v]);
      this->Parameter.push_back(charts[c].parameter[v]);
    }
    for (const Triangle& t : chart.triangles)
    {
      this->Mesh.triangles.push_back(
        { t[0] + firstVertex, t[1] + firstVertex, t[2] + firstVertex });
      this->FaceChart.push_back(static_cast<int>(c));
    }
    for (int h = 0; h < chart.numberOfHalfedges(); ++h)
    {
      this->Mesh.twin.push_back(Halfedge(chart.twin[h] < 0 ? -1 : chart.twin[h] + firstHalfedge));
      this->Mesh.label.push_back(chart.label[h] < 0 ? -1 : this->rootOf(chart.label[h]));
      if (chart.twin[h] < 0 && chart.label[h] >= 0)
      {
        const auto [other, fresh] = waiting.try_emplace(this->Mesh.label.back(), firstHalfedge + h);
        if (!fresh)
        {
          this->Mesh.glue(other->second, firstHalfedge + h);
        }
      }
    }
  }
  this->Count.reserve(this->Mesh.twin.size());
  for (int h = 0; h < this->Mesh.numberOfHalfedges(); ++h)
  {
    if (h > this->Mesh.twin[h])
    {
      ++this->Count[this->edgeKey(h)];
    }
  }
}

/// Both triangles that the flip of h would make are positive in the parameter plane of their chart.
bool Stitcher::isConvex(int h) const
{
  const int g = this->Mesh.twin[h];
  const Vec2& a = this->Parameter[this->Mesh.tail(h)];
  const Vec2& b = this->Parameter[this->Mesh.head(h)];
  const Vec2& c = this->Parameter[this->Mesh.apex(h)];
  const Vec2& d = this->Parameter[this->Mesh.apex(g)];
  return orient2(d, c, a) > 0 && orient2(c, d, b) > 0;
}

double Stitcher::height(int a, int b, int c) const
{
  const Vec3& p = this->Position[this->SampleOf[a]];
  const Vec3& q = this->Position[this->SampleOf[b]];
  const Vec3& r = this->Position[this->SampleOf[c]];
  const double longest =
    std::max({ (q - p).squaredNorm(), (r - q).squaredNorm(), (p - r).squaredNorm() });
  return longest > 0 ? 2. * triangleArea(p, q, r) / longest : 0.;
}

double Stitcher::worstHeight(int h) const
{
  const TriangleComplex& m = this->Mesh;
  const int g = m.twin[h];
  return std::min(
    this->height(m.tail(h), m.head(h), m.apex(h)), this->height(m.tail(g), m.head(g), m.apex(g)));
}

double Stitcher::worstHeightAfter(int h) const
{
  const TriangleComplex& m = this->Mesh;
  const int c = m.apex(h);
  const int d = m.apex(m.twin[h]);
  return std::min(this->height(d, c, m.tail(h)), this->height(c, d, m.head(h)));
}

bool Stitcher::tryBadEdge(int h, bool onlyConvex)
{
  const auto allowed = [&](int e) {
    return this->canFlip(e) && (!onlyConvex || this->isConvex(e)) && this->flipIsSimple(e);
  };
  if (!this->canFlip(h))
  {
    return false;
  }
  if (allowed(h))
  {
    this->flip(h);
    return true;
  }
  // Swap an edge beside it first, if that opens the way.
  const int g = this->Mesh.twin[h];
  for (int e : { nextHalfedge(h), previousHalfedge(h), nextHalfedge(g), previousHalfedge(g) })
  {
    if (allowed(e))
    {
      this->flip(e);
      if (allowed(h))
      {
        this->flip(h);
        return true;
      }
      for (int back = 0; back < 3; ++back) // a flip turns the diagonal by a quarter: three more
                                           // undo it
      {
        this->flip(e);
      }
    }
  }
  return false;
}

bool Stitcher::resolveRepeatedEdges()
{
  // First swaps that keep the parameter plane unfolded; where these do not do, any that keep the
  // topology; then of seams too.
  for (int stage = 0; stage < 3; ++stage)
  {
    const bool onlyConvex = stage == 0;
    this->SeamsMayGo = stage == 2;
    bool changed = true;
    while (changed)
    {
      changed = false;
      this->Unresolved = -1;
      for (int h = 0; h < this->Mesh.numberOfHalfedges(); ++h)
      {
        if (this->isBad(h))
        {
          if (this->tryBadEdge(h, onlyConvex))
          {
            changed = true;
          }
          else
          {
            this->Unresolved = h;
          }
        }
      }
    }
    bool clean = true;
    for (int h = 0; h < this->Mesh.numberOfHalfedges() && clean; ++h)
    {
      clean = !this->isBad(h);
    }
    if (clean)
    {
      this->SeamsMayGo = false;
      return true;
    }
  }
  return false;
}

std::vector<char> Stitcher::labelsWithEdge()
{
  std::vector<char> present(this->Root.size(), 0);
  for (int l : this->Mesh.label)
  {
    if (l >= 0)
    {
      present[l] = 1;
    }
  }
  for (std::size_t l = 0; l < present.size(); ++l)
  {
    present[l] = present[this->rootOf(static_cast<int>(l))];
  }
  return present;
}

void Stitcher::resolveDegenerateTriangles()
{
  // Corners of the rectangle that lie on straight lines of the surface leave triangles without
  // area.
  for (int round = 0; round < 10; ++round)
  {
    bool changed = false;
    for (int f = 0; f < static_cast<int>(this->Mesh.triangles.size()); ++f)
    {
      const Triangle& t = this->Mesh.triangles[f];
      if (this->height(t[0], t[1], t[2]) > MinimumHeight)
      {
        continue;
      }
      int best = -1;
      double bestHeight = 0;
      for (int h = 3 * f; h < 3 * f + 3; ++h)
      {
        if (this->canFlip(h) && this->flipIsSimple(h))
        {
          const double after = this->worstHeightAfter(h);
          if (after > bestHeight && after > this->worstHeight(h))
          {
            best = h;
            bestHeight = after;
          }
        }
      }
      if (best >= 0)
      {
        this->flip(best);
        changed = true;
      }
    }
    if (!changed)
    {
      return;
    }
  }
}
}

Status stitchCharts(const AtlasSurface& surface, const FeatureGraph& graph,
  const BackboneIntervals& intervals, const std::vector<ChartTriangulation>& charts,
  const std::vector<Sample>& samples, std::vector<Triangle>& triangles, std::vector<char>& hasEdge)
{
  std::vector<Vec3> positions;
  for (const Sample& s : samples)
  {
    positions.push_back(surface.position(s.face, s.bary));
  }
  std::vector<char> isSeam(intervals.count(), 0);
  for (int l = 0; l < intervals.count(); ++l)
  {
    isSeam[l] = graph.backbones[intervals.backbone(l)].type == BackboneType::Seam;
  }
  Stitcher stitcher(charts, std::move(positions), isSeam);
  if (!stitcher.resolveRepeatedEdges())
  {
    return Status::error("Chart " + std::to_string(stitcher.chartOfUnresolvedEdge()) +
      " is too small for its share of the samples: two of them would be joined by two edges; use "
      "more points.");
  }
  stitcher.resolveDegenerateTriangles();
  hasEdge = stitcher.labelsWithEdge();
  for (int l = 0; l < intervals.count(); ++l)
  {
    if (!hasEdge[l] && !isSeam[l])
    {
      return Status::error("Two neighbouring samples of backbone " +
        std::to_string(intervals.backbone(l)) +
        " could not be joined by an edge; use more points.");
    }
  }
  triangles.clear();
  triangles.reserve(stitcher.mesh().triangles.size());
  for (const Triangle& t : stitcher.mesh().triangles)
  {
    triangles.push_back({ stitcher.sample(t[0]), stitcher.sample(t[1]), stitcher.sample(t[2]) });
  }
  return Status::success();
}
}
