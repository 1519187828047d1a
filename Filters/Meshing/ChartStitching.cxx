// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ChartStitching.h"

#include <algorithm>
#include <cstdint>
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
    ElementArray<Label, char> isSeam);
  ElementArray<Label, char> labelsWithEdge();
  bool resolveRepeatedEdges(const Stop& stop);
  void resolveDegenerateTriangles(const Stop& stop);
  const TriangleComplex& mesh() const { return this->Mesh; }
  int sample(Vertex v) const { return this->SampleOf[v]; }
  MeshFault fault() const;

private:
  static std::uint64_t key(int a, int b)
  {
    return (static_cast<std::uint64_t>(std::min(a, b)) << 32) |
      static_cast<unsigned int>(std::max(a, b));
  }
  std::uint64_t edgeKey(Halfedge h) const
  {
    return key(this->sample(this->Mesh.tail(h)), this->sample(this->Mesh.head(h)));
  }
  bool isBad(Halfedge h) const
  {
    const std::uint64_t k = this->edgeKey(h);
    return (k >> 32) == (k & 0xffffffffu) || this->Count.at(k) > 1;
  }
  bool canFlip(Halfedge h) const
  {
    const Label label = this->Mesh.label[h];
    return !this->Mesh.isBoundary(h) && faceOf(h) != faceOf(this->Mesh.twin[h]) && // a triangle
                                                                                   // glued to
                                                                                   // itself has no
                                                                                   // other diagonal
      (!label.valid() || (this->SeamsMayGo && this->IsSeam[label]));
  }
  Label rootOf(Label label)
  {
    while (this->Root[label] != label)
    {
      label = this->Root[label] = this->Root[this->Root[label]];
    }
    return label;
  }
  /// The flip of h yields an edge that is not there yet.
  bool flipIsSimple(Halfedge h) const
  {
    const int c = this->sample(this->Mesh.apex(h));
    const int d = this->sample(this->Mesh.apex(this->Mesh.twin[h]));
    const auto found = this->Count.find(key(c, d));
    return c != d && (found == this->Count.end() || found->second == 0);
  }
  bool isConvex(Halfedge h) const;
  void flip(Halfedge h)
  {
    --this->Count[this->edgeKey(h)];
    this->Mesh.label[h] = this->Mesh.label[this->Mesh.twin[h]] = Label();
    this->Mesh.flip(h);
    ++this->Count[this->edgeKey(h)];
  }
  double height(Vertex a, Vertex b, Vertex c) const;
  double worstHeight(Halfedge h) const;
  double worstHeightAfter(Halfedge h) const;
  bool tryBadEdge(Halfedge h, bool onlyConvex);

  TriangleComplex Mesh;
  ElementArray<Vertex, int> SampleOf;
  ElementArray<Vertex, Vec2> Parameter;
  std::vector<Vec3> Position; // by sample
  ElementArray<Face, Chart> FaceChart;
  std::unordered_map<std::uint64_t, int> Count; // edges between two samples
  ElementArray<Label, char> IsSeam;
  ElementArray<Label, Label> Root; // of merged labels
  bool SeamsMayGo = false;
};

Stitcher::Stitcher(const std::vector<ChartTriangulation>& charts, std::vector<Vec3> positions,
  ElementArray<Label, char> isSeam)
  : Position(std::move(positions))
  , IsSeam(std::move(isSeam))
{
  for (Label l : this->IsSeam.ids())
  {
    this->Root.push_back(l);
  }
  for (const ChartTriangulation& chart : charts)
  {
    for (const auto& pair : chart.merged)
    {
      // What is no seam stands for both.
      const Label a = this->rootOf(pair[0]);
      const Label b = this->rootOf(pair[1]);
      const bool keepA = this->IsSeam[a] == this->IsSeam[b] ? a < b : !this->IsSeam[a];
      this->Root[keepA ? b : a] = keepA ? a : b;
    }
  }
  // By label, the boundary halfedge whose other side is still to come.
  std::unordered_map<Label, Halfedge> waiting;
  for (std::size_t c = 0; c < charts.size(); ++c)
  {
    const TriangleComplex& chart = charts[c].complex;
    const int firstVertex = static_cast<int>(this->SampleOf.size());
    const int firstFace = this->Mesh.numberOfFaces();
    for (int v = 0; v < charts[c].numberOfVertices(); ++v)
    {
      this->SampleOf.push_back(charts[c].sample[v]);
      this->Parameter.push_back(charts[c].parameter[v]);
    }
    for (const Triangle& t : chart.triangles)
    {
      this->Mesh.triangles.push_back(
        { t[0] + firstVertex, t[1] + firstVertex, t[2] + firstVertex });
      this->FaceChart.push_back(Chart(static_cast<int>(c)));
    }
    const auto here = [firstFace](Halfedge h) {
      return halfedgeOf(Face(faceOf(h).index() + firstFace), cornerOf(h));
    };
    for (Halfedge h : chart.halfedges())
    {
      const Label label = chart.label[h].valid() ? this->rootOf(chart.label[h]) : Label();
      this->Mesh.twin.push_back(chart.isBoundary(h) ? Halfedge() : here(chart.twin[h]));
      this->Mesh.label.push_back(label);
      if (chart.isBoundary(h) && label.valid())
      {
        const auto [other, fresh] = waiting.try_emplace(label, here(h));
        if (!fresh)
        {
          this->Mesh.glue(other->second, here(h));
        }
      }
    }
  }
  this->Count.reserve(this->Mesh.twin.size());
  for (Halfedge h : this->Mesh.halfedges())
  {
    if (h > this->Mesh.twin[h])
    {
      ++this->Count[this->edgeKey(h)];
    }
  }
}

/// Both triangles that the flip of h would make are positive in the parameter plane of their chart.
bool Stitcher::isConvex(Halfedge h) const
{
  const Halfedge g = this->Mesh.twin[h];
  const Vec2& a = this->Parameter[this->Mesh.tail(h)];
  const Vec2& b = this->Parameter[this->Mesh.head(h)];
  const Vec2& c = this->Parameter[this->Mesh.apex(h)];
  const Vec2& d = this->Parameter[this->Mesh.apex(g)];
  return orient2(d, c, a) > 0 && orient2(c, d, b) > 0;
}

double Stitcher::height(Vertex a, Vertex b, Vertex c) const
{
  const Vec3& p = this->Position[this->sample(a)];
  const Vec3& q = this->Position[this->sample(b)];
  const Vec3& r = this->Position[this->sample(c)];
  const double longest =
    std::max({ (q - p).squaredNorm(), (r - q).squaredNorm(), (p - r).squaredNorm() });
  return longest > 0 ? 2. * triangleArea(p, q, r) / longest : 0.;
}

double Stitcher::worstHeight(Halfedge h) const
{
  const TriangleComplex& m = this->Mesh;
  const Halfedge g = m.twin[h];
  return std::min(
    this->height(m.tail(h), m.head(h), m.apex(h)), this->height(m.tail(g), m.head(g), m.apex(g)));
}

double Stitcher::worstHeightAfter(Halfedge h) const
{
  const TriangleComplex& m = this->Mesh;
  const Vertex c = m.apex(h);
  const Vertex d = m.apex(m.twin[h]);
  return std::min(this->height(d, c, m.tail(h)), this->height(c, d, m.head(h)));
}

bool Stitcher::tryBadEdge(Halfedge h, bool onlyConvex)
{
  const auto allowed = [&](Halfedge e) {
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
  const Halfedge g = this->Mesh.twin[h];
  for (Halfedge e : { nextHalfedge(h), previousHalfedge(h), nextHalfedge(g), previousHalfedge(g) })
  {
    if (allowed(e))
    {
      const bool behind = e == nextHalfedge(h) || e == nextHalfedge(g);
      this->flip(e);
      // Which turned the sides of its quad: the bad edge is another halfedge now.
      const Halfedge bad = behind ? nextHalfedge(e) : previousHalfedge(this->Mesh.twin[e]);
      if (allowed(bad))
      {
        this->flip(bad);
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

bool Stitcher::resolveRepeatedEdges(const Stop& stop)
{
  // First swaps that keep the parameter plane unfolded; where these do not do, any that keep the
  // topology; then of seams too. Every swap that stays leaves fewer edges too many, so this ends.
  for (int stage = 0; stage < 3; ++stage)
  {
    const bool onlyConvex = stage == 0;
    this->SeamsMayGo = stage == 2;
    bool changed = true;
    while (changed)
    {
      changed = false;
      for (Halfedge h : this->Mesh.halfedges())
      {
        if (isAsked(stop))
        {
          return false;
        }
        changed = (this->isBad(h) && this->tryBadEdge(h, onlyConvex)) || changed;
      }
    }
    bool clean = true;
    for (Halfedge h : this->Mesh.halfedges())
    {
      clean = clean && !this->isBad(h);
    }
    if (clean)
    {
      this->SeamsMayGo = false;
      return true;
    }
  }
  return false;
}

/// Once edges are halved, none joins a sample to itself, and two that joined the same ones join
/// others. Those of samples to themselves go first: what lies between their ends lies between those
/// of the edges about them, too.
MeshFault Stitcher::fault() const
{
  MeshFault fault;
  ElementArray<Face, char> isMended(static_cast<std::size_t>(this->Mesh.numberOfFaces()), 0);
  for (const bool ofLoops : { true, false })
  {
    for (Halfedge h : this->Mesh.halfedges())
    {
      const Vertex a = this->Mesh.tail(h);
      const Vertex b = this->Mesh.head(h);
      if (this->Mesh.isBoundary(h) || !this->isBad(h))
      {
        continue;
      }
      const Face f = faceOf(h);
      const Face g = faceOf(this->Mesh.twin[h]);
      fault.chart = this->FaceChart[f];
      if (!this->Mesh.label[h].valid() && (this->sample(a) == this->sample(b)) == ofLoops &&
        !isMended[f] && !isMended[g])
      {
        isMended[f] = isMended[g] = 1;
        fault.places.emplace_back(
          this->FaceChart[f], 0.5 * (this->Parameter[a] + this->Parameter[b]));
      }
    }
  }
  return fault;
}

ElementArray<Label, char> Stitcher::labelsWithEdge()
{
  ElementArray<Label, char> present(this->Root.size(), 0);
  for (Label l : this->Mesh.label)
  {
    if (l.valid())
    {
      present[l] = 1;
    }
  }
  for (Label l : present.ids())
  {
    present[l] = present[this->rootOf(l)];
  }
  return present;
}

void Stitcher::resolveDegenerateTriangles(const Stop& stop)
{
  // Corners of the rectangle that lie on straight lines of the surface leave triangles without
  // area.
  for (int round = 0; round < 10; ++round)
  {
    bool changed = false;
    for (Face f : this->Mesh.faces())
    {
      if (isAsked(stop))
      {
        return;
      }
      const Halfedge first = halfedgeOf(f, 0);
      if (this->height(this->Mesh.tail(first), this->Mesh.head(first), this->Mesh.apex(first)) >
        MinimumHeight)
      {
        continue;
      }
      Halfedge best;
      double bestHeight = 0;
      for (Halfedge h : halfedgesOf(f))
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
      if (best.valid())
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
  const std::vector<Sample>& samples, std::vector<Triangle>& triangles,
  ElementArray<Label, char>& hasEdge, MeshFault& fault, const Stop& stop)
{
  std::vector<Vec3> positions;
  for (const Sample& s : samples)
  {
    positions.push_back(surface.position(s.face, s.bary));
  }
  ElementArray<Label, char> isSeam(static_cast<std::size_t>(intervals.count()), 0);
  for (Label l : intervals.labels())
  {
    isSeam[l] = graph.backbones[intervals.backbone(l)].type == BackboneType::Seam;
  }
  Stitcher stitcher(charts, std::move(positions), isSeam);
  if (!stitcher.resolveRepeatedEdges(stop))
  {
    if (isAsked(stop))
    {
      return Status::aborted();
    }
    fault = stitcher.fault();
    return Status::tooFewPoints("Chart " + std::to_string(fault.chart.index()) +
      " is too small for its share of the samples: two of them would be joined by two edges; use "
      "more points.");
  }
  stitcher.resolveDegenerateTriangles(stop);
  hasEdge = stitcher.labelsWithEdge();
  for (Label l : intervals.labels())
  {
    if (!hasEdge[l] && !isSeam[l])
    {
      return Status::tooFewPoints("Two neighbouring samples of backbone " +
        std::to_string(intervals.backbone(l)) +
        " could not be joined by an edge; use more points.");
    }
  }
  triangles.clear();
  triangles.reserve(stitcher.mesh().triangles.size());
  for (const Triangle& t : stitcher.mesh().triangles)
  {
    triangles.push_back({ stitcher.sample(Vertex(t[0])), stitcher.sample(Vertex(t[1])),
      stitcher.sample(Vertex(t[2])) });
  }
  return Status::success();
}
}
