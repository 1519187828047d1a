// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OptimizedMesh.h"

#include "MeshCreation.h"
#include "Tuning.h"

#include <algorithm>
#include <utility>

namespace stipple
{
namespace
{
/// Tells the points that constraints became which users named, or which were found: the tips of
/// cones. Also on backbones, where their samples are of a backbone's kind.
class ConstraintFinder
{
public:
  ConstraintFinder(const stipple::Atlas& atlas, bool found)
  {
    const AtlasSurface& surface = atlas.surface();
    for (const ConstraintPoint& c : atlas.graph().constraints)
    {
      if ((c.keep == Keep::Nothing) == found)
      {
        this->Places.push_back(surface.position(surface.chartBegin[c.chart] + c.chartCell, c.bary));
      }
    }
    std::sort(this->Places.begin(), this->Places.end(),
      [](const Vec3& a, const Vec3& b) { return a.x() < b.x(); });
    this->Reach =
      this->Places.empty() ? 0. : Tuning::ConstraintTolerance * surface.boundingBoxDiagonal();
  }
  bool isConstraint(const Vec3& p) const
  {
    auto at = std::lower_bound(this->Places.begin(), this->Places.end(), p.x() - this->Reach,
      [](const Vec3& a, double x) { return a.x() < x; });
    for (; at != this->Places.end() && at->x() <= p.x() + this->Reach; ++at)
    {
      if ((*at - p).norm() <= this->Reach)
      {
        return true;
      }
    }
    return false;
  }

private:
  std::vector<Vec3> Places; // by x
  double Reach = 0;
};
}

double OptimizedMesh::spacingAtUnitDensity() const
{
  const AtlasSurface& surface = this->Atlas->surface();
  double area = 0;
  for (const Face f : surface.faces())
  {
    area += surface.faceArea(f);
  }
  // Samples are spread by the density: the sum over them of what each stands for is the area.
  double sum = 0;
  for (const Sample& s : this->Original)
  {
    sum += 1. / this->densityAt(this->pointAt({ s.face, s.bary }));
  }
  return std::sqrt(2. / std::sqrt(3.) * area / sum);
}

void OptimizedMesh::findCreaseBackbones(
  const std::vector<std::vector<int>>& chains, bool allAreCreases)
{
  const std::vector<Backbone>& backbones = this->Atlas->graph().backbones;
  this->IsCreaseBackbone.assign(backbones.size(), 1);
  bool isLikeAtlas = true;
  double unit = 0; // spacing, once it is known
  for (std::size_t b = 0; b < backbones.size(); ++b)
  {
    const double edges = std::max(1., static_cast<double>(chains[b].size()) - 1.);
    double length = this->Atlas->traces()[b].length() / edges;
    if (backbones[b].pitch > 0) // samples on many lines close together are few on each
    {
      unit = unit > 0 ? unit : this->spacingAtUnitDensity();
      const SurfacePlace middle =
        this->Atlas->placeOfBackbone(static_cast<int>(b), 0.5 * this->Atlas->traces()[b].length());
      length = unit / std::sqrt(this->densityAt(this->pointAt(middle)));
    }
    const bool isCrease =
      backbones[b].isCreaseTo(length) || (allAreCreases && backbones[b].type != BackboneType::Seam);
    this->IsCreaseBackbone[b] = isCrease ? 1 : 0;
    isLikeAtlas = isLikeAtlas && (isCrease || backbones[b].type == BackboneType::Seam);
  }
  if (!isLikeAtlas)
  {
    this->partByCreases();
  }
}

void OptimizedMesh::partByCreases()
{
  const std::vector<Backbone>& backbones = this->Atlas->graph().backbones;
  std::vector<char> isWall = this->IsCreaseBackbone;
  for (std::size_t b = 0; b < backbones.size(); ++b)
  {
    isWall[b] = isWall[b] != 0 && backbones[b].type == BackboneType::Sharp ? 1 : 0;
  }
  const std::vector<char> walls = this->Atlas->halfedgesOn(isWall);
  this->OwnWalk = std::make_shared<const SurfaceWalk>(this->Atlas->surface(), walls);
  this->OwnNormals =
    std::make_shared<const ElementArray<Face, Vec3>>(this->Atlas->smoothNormalsWith(walls));
}

std::vector<char> OptimizedMesh::fixedNodes() const
{
  const FeatureGraph& graph = this->Atlas->graph();
  // Corners, also tips of cones that a seam runs through, and where creases end.
  std::vector<char> result = graph.isCorner;
  result.resize(this->Atlas->surface().points.size(), 0);
  for (std::size_t b = 0; b < graph.backbones.size(); ++b)
  {
    if (graph.backbones[b].type == BackboneType::Sharp &&
      !this->isCreaseBackbone(static_cast<int>(b)))
    {
      for (const int p : graph.backbones[b].points)
      {
        result[p] = 0; // they are corners of nothing else, or marked below
      }
    }
  }
  for (std::size_t b = 0; b < graph.backbones.size(); ++b)
  {
    const Backbone& backbone = graph.backbones[b];
    if (!backbone.closed && this->isCreaseBackbone(static_cast<int>(b)))
    {
      result[backbone.points.front()] = result[backbone.points.back()] = 1;
    }
  }
  return result;
}

Status OptimizedMesh::begin(
  const stipple::Atlas& atlas, const DensityField& density, const std::vector<Sample>& samples)
{
  this->Atlas = &atlas;
  this->Field = &density;
  this->Original = samples;
  const std::size_t n = samples.size();
  const FeatureGraph& graph = atlas.graph();
  this->State.assign(n, VertexState());
  this->Free.assign(n, Freedom::Surface);
  this->BackboneOf.assign(n, -1);
  this->IsConstraint.assign(n, 0);
  this->Absorbed.assign(n, {});
  for (std::size_t i = 0; i < n; ++i)
  {
    const int backbone = samples[i].backbone;
    if (samples[i].kind == SampleKind::Backbone &&
      (backbone < 0 || backbone >= static_cast<int>(graph.backbones.size())))
    {
      return Status::error("Point " + std::to_string(i) + " lies on backbone " +
        std::to_string(backbone) +
        ", which the feature graph does not have: pass the one of the mesh.");
    }
  }
  return Status::success();
}

void OptimizedMesh::placeVertices(const std::vector<Sample>& samples)
{
  const std::vector<char> fixedNode = this->fixedNodes();
  const ConstraintFinder named(*this->Atlas, false);
  const ConstraintFinder found(*this->Atlas, true);
  for (const Vertex v : this->vertices())
  {
    const Sample& s = samples[v.index()];
    this->put(v, this->pointAt({ s.face, s.bary }));
    const Vec3& p = this->position(v);
    this->IsConstraint[v] = s.kind != SampleKind::Interior &&
      (named.isConstraint(p) || (s.kind == SampleKind::Constraint && !found.isConstraint(p)));
    if (s.kind == SampleKind::Constraint ||
      (s.kind == SampleKind::Corner && s.surfacePoint >= 0 && fixedNode[s.surfacePoint]))
    {
      this->Free[v] = Freedom::None;
    }
    else if (s.kind == SampleKind::Backbone)
    {
      if (this->isCreaseBackbone(s.backbone))
      {
        this->Free[v] = this->isConstraint(v) ? Freedom::None : Freedom::Backbone;
        this->BackboneOf[v] = s.backbone;
        this->State[v].arcLength = s.arcLength;
        this->findOtherNormal(v);
        continue;
      }
    }
    if (this->isConstraint(v) && this->isFree(v)) // on a seam, which heals
    {
      this->Free[v] = Freedom::None;
      this->Original[v.index()] = { SampleKind::Constraint, s.face, s.bary, -1, 0., -1 };
    }
  }
}

Status OptimizedMesh::build(const stipple::Atlas& atlas, const DensityField& density,
  const std::vector<Sample>& samples, const std::vector<Triangle>& triangles, bool allAreCreases)
{
  if (Status status = this->begin(atlas, density, samples); !status.ok())
  {
    return status;
  }
  const FeatureGraph& graph = atlas.graph();
  const std::vector<std::vector<int>> samplesOf = backboneChains(graph, samples);
  this->findCreaseBackbones(samplesOf, allAreCreases);
  this->placeVertices(samples);
  std::vector<Chain> chains;
  for (const std::vector<int>& samplesOfChain : samplesOf)
  {
    const std::size_t b = chains.size();
    chains.emplace_back();
    if (!this->isCreaseBackbone(static_cast<int>(b)))
    {
      continue;
    }
    for (const int v : samplesOfChain)
    {
      chains[b].push_back({ Vertex(v), this->arcLength(Vertex(v)) });
    }
    if (!graph.backbones[b].closed && !chains[b].empty())
    {
      chains[b].front().arcLength = 0;
      chains[b].back().arcLength = atlas.traces()[b].length();
    }
  }
  const Status status = this->connect(triangles);
  return status.ok() ? this->markCreases(std::move(chains)) : status;
}

Status OptimizedMesh::build(const stipple::Atlas& atlas, const DensityField& density,
  const std::vector<Sample>& samples, const std::vector<Triangle>& triangles,
  std::vector<Chain> chains, int numberOfHeld)
{
  if (Status status = this->begin(atlas, density, samples); !status.ok())
  {
    return status;
  }
  this->Chains = std::move(chains);
  this->findCreaseBackbones(idsOf(this->Chains), false);
  for (std::size_t b = 0; b < this->Chains.size(); ++b)
  {
    const bool isCrease = this->isCreaseBackbone(static_cast<int>(b)) && !this->Chains[b].empty();
    this->IsCreaseBackbone[b] = isCrease ? 1 : 0;
    this->Chains[b].resize(isCrease ? this->Chains[b].size() : 0);
  }
  this->placeVertices(samples);
  for (std::size_t b = 0; b < this->Chains.size(); ++b)
  {
    const bool isFound = atlas.graph().backbones[b].keep == Keep::Nothing;
    for (const BackboneVertex& v : this->Chains[b])
    {
      const bool isOnIt = this->backbone(v.vertex) == static_cast<int>(b);
      if (!isOnIt && (!isFound || v.vertex.index() < numberOfHeld))
      {
        this->Free[v.vertex] = Freedom::None;
      }
    }
  }
  const Status status = this->connect(triangles);
  return status.ok() ? this->markCreases(std::move(this->Chains)) : status;
}

Status OptimizedMesh::buildPart(const stipple::Atlas& atlas, const DensityField& density,
  const std::vector<SurfacePlace>& places, const std::vector<char>& isMovable,
  const std::vector<Triangle>& triangles, const std::vector<std::array<int, 2>>& fixedEdges)
{
  this->Atlas = &atlas;
  this->Field = &density;
  this->IsPart = true;
  const std::size_t n = places.size();
  this->Original.assign(n, Sample());
  this->State.assign(n, VertexState());
  this->Free.assign(n, Freedom::Surface);
  this->BackboneOf.assign(n, -1);
  this->IsConstraint.assign(n, 0);
  this->Absorbed.assign(n, {});
  for (const Vertex v : this->vertices())
  {
    const SurfacePlace& place = places[v.index()];
    this->Original[v.index()].face = place.face;
    this->Original[v.index()].bary = place.bary;
    this->put(v, this->pointAt(place));
    this->Free[v] = isMovable[v.index()] != 0 ? Freedom::Surface : Freedom::None;
  }
  this->IsCreaseBackbone.clear();
  for (const Backbone& b : atlas.graph().backbones)
  {
    this->IsCreaseBackbone.push_back(b.type != BackboneType::Seam ? 1 : 0);
  }
  if (Status status = this->connect(triangles); !status.ok())
  {
    return status;
  }
  if (Status status = this->markCreases({}); !status.ok())
  {
    return status;
  }
  for (const auto& [from, to] : fixedEdges)
  {
    const auto h = this->Graph.find_halfedge(raw(Vertex(from)), raw(Vertex(to)));
    if (h.is_valid())
    {
      this->CreaseOf[this->edge(id(h))] = static_cast<int>(this->Creases.size());
      this->Creases.push_back({ -1, { Vertex(from), 0. }, { Vertex(to), 0. } });
    }
  }
  return Status::success();
}

Status OptimizedMesh::rebuild(Change change)
{
  this->Changes += change.features + change.swaps;
  this->SimplifiedFeatures += change.features;
  for (const auto& [v, there] : change.freed)
  {
    this->Free[v] = Freedom::Surface;
    this->BackboneOf[v] = -1;
    this->State[v].arcLength = 0;
    this->put(v, there);
    this->Original[v.index()] = { SampleKind::Interior, there.place.face, there.place.bary, -1, 0.,
      -1 };
  }
  for (const auto& [v, backbone, arcLength] : change.onBackbones)
  {
    this->Free[v] = Freedom::Backbone;
    this->BackboneOf[v] = backbone;
    this->putOnBackbone(v, arcLength);
    const SurfacePlace& place = this->place(v);
    this->Original[v.index()] = { SampleKind::Backbone, place.face, place.bary, backbone, arcLength,
      -1 };
  }
  for (const Vertex v : change.fixed)
  {
    this->Free[v] = Freedom::None;
  }
  if (!change.absorbed.empty())
  {
    this->Absorbed = std::move(change.absorbed);
  }
  const Status status = this->connect(change.triangles);
  return status.ok() ? this->markCreases(std::move(change.chains)) : status;
}

void OptimizedMesh::giveUp(const std::vector<int>& backbones)
{
  std::vector<Vertex> touched;
  for (const int b : backbones)
  {
    for (const BackboneVertex& v : this->Chains[b])
    {
      touched.push_back(v.vertex);
    }
    this->Chains[b].clear();
    this->IsCreaseBackbone[b] = 0;
    ++this->Changes;
    ++this->SimplifiedFeatures;
  }
  for (int& crease : this->CreaseOf)
  {
    const bool isGone = crease >= 0 && this->Creases[crease].backbone >= 0 &&
      this->IsCreaseBackbone[this->Creases[crease].backbone] == 0;
    crease = isGone ? -1 : crease;
  }
  this->partByCreases();
  for (const Vertex v : touched)
  {
    bool isHeld = this->isBoundary(v) || this->isConstraint(v);
    this->forEachHalfedge(v, [&](Halfedge h) { isHeld = isHeld || this->isCrease(this->edge(h)); });
    if (isHeld)
    {
      const int b = this->backbone(v);
      this->Free[v] = b >= 0 && this->IsCreaseBackbone[b] == 0 ? Freedom::None : this->Free[v];
    }
    else
    {
      const SurfacePlace& place = this->place(v);
      this->Free[v] = Freedom::Surface;
      this->BackboneOf[v] = -1;
      this->State[v].arcLength = 0;
      this->Original[v.index()] = { SampleKind::Interior, place.face, place.bary, -1, 0., -1 };
    }
  }
  for (const Vertex v : this->vertices()) // their normals are others
  {
    this->put(v, this->pointAt(this->place(v)));
    if (this->backbone(v) >= 0)
    {
      this->findOtherNormal(v);
    }
  }
}

/// Fills OpenMesh's arrays directly: faster than add_face(), and independent of the order of the
/// triangles.
Status OptimizedMesh::connect(const std::vector<Triangle>& triangles)
{
  using Handle = OpenMesh::HalfedgeHandle;
  const auto twin = halfedgeTwins(triangles);
  const int n = static_cast<int>(triangles.size());
  this->Graph.clear();
  this->Graph.reserve(this->State.size(), twin.size() / 2 + 1, triangles.size());
  for (std::size_t v = 0; v < this->State.size(); ++v)
  {
    this->Graph.new_vertex();
  }
  ElementArray<Halfedge, Handle> own(twin.size());
  const auto tail = [&](Halfedge h) { return Vertex(triangles[faceOf(h).index()][cornerOf(h)]); };
  ElementArray<Vertex, Handle> outside(this->State.size()); // boundary halfedge out of a vertex
  for (const Halfedge h : twin.ids())
  {
    const Vertex head = tail(nextHalfedge(h));
    if (twin[h] == NonManifoldTwin)
    {
      return Status::error("The mesh's edge between the points " + std::to_string(tail(h).index()) +
        " and " + std::to_string(head.index()) +
        " is not manifold or not consistently oriented: pass the output of vtkCDTRemesh.");
    }
    if (!twin[h].valid() || h < twin[h])
    {
      own[h] = this->Graph.new_edge(raw(tail(h)), raw(head));
      const Handle opposite = this->Graph.opposite_halfedge_handle(own[h]);
      if (twin[h].valid())
      {
        own[twin[h]] = opposite;
      }
      else
      {
        this->Graph.set_boundary(opposite);
        outside[head] = opposite;
      }
    }
  }
  for (int f = 0; f < n; ++f)
  {
    const auto face = this->Graph.new_face();
    this->Graph.set_halfedge_handle(face, own[halfedgeOf(Face(f), 0)]);
    for (const Halfedge h : halfedgesOf(Face(f)))
    {
      this->Graph.set_face_handle(own[h], face);
      this->Graph.set_next_halfedge_handle(own[h], own[nextHalfedge(h)]);
      this->Graph.set_halfedge_handle(raw(tail(h)), own[h]);
    }
  }
  for (const Handle h : outside)
  {
    if (h.is_valid())
    {
      this->Graph.set_next_halfedge_handle(h, outside[this->to(id(h))]);
      this->Graph.set_halfedge_handle(this->Graph.from_vertex_handle(h), h);
    }
  }
  for (const Vertex v : this->vertices())
  {
    if (!this->halfedge(v).valid())
    {
      return Status::error("Point " + std::to_string(v.index()) +
        " of the mesh is in no triangle: pass the output of vtkCDTRemesh.");
    }
  }
  return Status::success();
}

Status OptimizedMesh::markCreases(std::vector<Chain> chains)
{
  this->Chains = std::move(chains);
  this->CreaseOf.assign(this->Graph.n_edges(), -1);
  this->Creases.clear();
  for (std::size_t b = 0; b < this->Chains.size(); ++b)
  {
    const Chain& chain = this->Chains[b];
    for (std::size_t i = 1; i < chain.size(); ++i)
    {
      const Vertex from = chain[i - 1].vertex;
      const Vertex to = chain[i].vertex;
      const auto h = this->Graph.find_halfedge(raw(from), raw(to));
      if (!h.is_valid())
      {
        return Status::error("The mesh has no edge between the points " +
          std::to_string(from.index()) + " and " + std::to_string(to.index()) +
          ", neighbours on backbone " + std::to_string(b) +
          ": pass the output of vtkCDTRemesh and its feature graph.");
      }
      this->CreaseOf[this->edge(id(h))] = static_cast<int>(this->Creases.size());
      this->Creases.push_back({ static_cast<int>(b), chain[i - 1], chain[i] });
    }
  }
  return Status::success();
}

SurfacePoint OptimizedMesh::pointAt(const SurfacePlace& place) const
{
  return { place, this->surfaceWalk().position(place), this->smoothNormal(place.face) };
}

SurfacePoint OptimizedMesh::walk(const SurfacePlace& from, const Vec3& step) const
{
  // Triangles without area have no normal, and what is computed from that no direction.
  return this->pointAt(step.allFinite() ? this->surfaceWalk().walk(from, step) : from);
}

double OptimizedMesh::densityAt(const SurfacePoint& point) const
{
  const double density =
    this->Field->uniform() ? 1. : this->Field->at(this->Atlas->surface(), point.place);
  if (this->Coarse.empty() && this->Fine.empty())
  {
    return density;
  }
  const Face face(point.place.face);
  const double growth =
    this->Coarse.growthAt(face, point.position) * this->Fine.growthAt(face, point.position);
  return density / (growth * growth);
}

void OptimizedMesh::coarsen(SpacingRegions regions)
{
  this->Coarse = std::move(regions);
  this->updateDensity();
}

void OptimizedMesh::refine(SpacingRegions regions)
{
  this->Fine = std::move(regions);
  this->updateDensity();
}

void OptimizedMesh::updateDensity()
{
  for (VertexState& state : this->State)
  {
    state.density = this->densityAt(state);
  }
}

void OptimizedMesh::put(Vertex v, const SurfacePoint& there)
{
  VertexState& state = this->State[v];
  static_cast<SurfacePoint&>(state) = there;
  state.density = this->densityAt(there);
}

void OptimizedMesh::putOnBackbone(Vertex v, double arcLength)
{
  const int backbone = this->BackboneOf[v];
  const double length = this->Atlas->traces()[backbone].length();
  if (this->Atlas->graph().backbones[backbone].closed)
  {
    arcLength -= length * std::floor(arcLength / length);
  }
  this->put(v, this->pointAt(this->Atlas->placeOfBackbone(backbone, arcLength)));
  this->State[v].arcLength = arcLength;
  this->findOtherNormal(v);
}

void OptimizedMesh::findOtherNormal(Vertex v)
{
  VertexState& state = this->State[v];
  state.otherNormal = state.normal;
  const BackboneTrace& trace = this->Atlas->traces()[this->BackboneOf[v]];
  if (trace.chart[0] >= 0 && trace.chart[1] >= 0)
  {
    const BackboneTrace::Place place = trace.locate(state.arcLength);
    const int side = state.place.face == trace.face(place, 1) ? 0 : 1;
    state.otherNormal = this->smoothNormal(trace.face(place, side));
  }
}

int OptimizedMesh::valence(Vertex v) const
{
  int n = 0;
  this->forEachHalfedge(v, [&n](Halfedge) { ++n; });
  return n;
}

Vec3 OptimizedMesh::faceNormal(Face f) const
{
  const auto [a, b, c] = this->corners(f);
  const Vec3& p = this->position(a);
  return (this->position(b) - p).cross(this->position(c) - p).normalized();
}

double OptimizedMesh::faceArea(Face f) const
{
  const auto [a, b, c] = this->corners(f);
  return triangleArea(this->position(a), this->position(b), this->position(c));
}

std::vector<Triangle> OptimizedMesh::triangles() const
{
  std::vector<Triangle> result;
  result.reserve(this->Graph.n_faces());
  for (const Face f : this->faces())
  {
    const auto [a, b, c] = this->corners(f);
    Triangle t = { a.index(), b.index(), c.index() };
    // Whatever swaps did to the halfedges: the smallest point comes first.
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    result.push_back(t);
  }
  return result;
}

std::vector<Sample> OptimizedMesh::samples() const
{
  std::vector<Sample> result = this->Original;
  for (const Vertex v : this->vertices())
  {
    Sample& s = result[v.index()];
    s.face = this->place(v).face;
    s.bary = this->place(v).bary;
    s.arcLength = this->arcLength(v);
    if (this->isFree(v)) // seams have healed: nothing tells their samples from others
    {
      s = { SampleKind::Interior, s.face, s.bary, -1, 0., -1 };
    }
  }
  return result;
}

bool OptimizedMesh::isFlat(const TriangleCorners& corners) const
{
  const Vec3& p = this->position(this->from(corners[0]));
  const Vec3& q = this->position(this->from(corners[1]));
  const Vec3& r = this->position(this->from(corners[2]));
  const double longest =
    std::max({ (q - p).squaredNorm(), (r - q).squaredNorm(), (p - r).squaredNorm() });
  return !((q - p).cross(r - p).norm() > Tuning::NoAngle * longest);
}

bool OptimizedMesh::isSound(const TriangleCorners& corners) const
{
  const Vertex a = this->from(corners[0]);
  const Vertex b = this->from(corners[1]);
  const Vertex c = this->from(corners[2]);
  const Vec3& p = this->position(a);
  const Vec3& q = this->position(b);
  const Vec3& r = this->position(c);
  const Vec3 n = (q - p).cross(r - p);
  const double area = n.norm();
  const double longest =
    std::max({ (q - p).squaredNorm(), (r - q).squaredNorm(), (p - r).squaredNorm() });
  if (!(area > Tuning::LeastSoundHeight * longest))
  {
    return false;
  }
  const bool isOnCreases = !this->isFree(a) && !this->isFree(b) && !this->isFree(c);
  return (isOnCreases ? this->normalAgreementOnCreases(corners, n)
                      : this->normalAgreement(a, b, c, n, area)) >= Tuning::LeastAgreement;
}

Vec3 OptimizedMesh::normalBeside(Halfedge h) const
{
  const Vertex v = this->from(h);
  const VertexState& state = this->State[v];
  // Turn clockwise to the crease: ahead on its backbone, the triangle is on the left of that.
  Halfedge crease = h;
  while (!this->isCrease(this->edge(crease)))
  {
    crease = this->next(this->opposite(crease));
    if (crease == h)
    {
      return state.normal;
    }
  }
  const Crease& c = this->crease(this->edge(crease));
  if (c.backbone < 0)
  {
    // No vertex of it moves: the triangle that there is lies between the same creases.
    return this->isBoundary(h) ? state.normal : this->faceNormal(this->face(h));
  }
  const bool ahead = c.from.vertex == v;
  const BackboneTrace& trace = this->Atlas->traces()[c.backbone];
  const double arcLength = this->arcLength(ahead ? c.from : c.to);
  const int side = ahead ? 0 : 1;
  if (this->Free[v] == Freedom::None)
  {
    return this->smoothNormal(trace.face(trace.locate(arcLength), side));
  }
  const bool hasLeft = state.place.face != trace.face(trace.locate(arcLength), 1);
  return ahead == hasLeft ? state.normal : state.otherNormal;
}

double OptimizedMesh::normalAgreementOnCreases(
  const TriangleCorners& corners, const Vec3& normal) const
{
  Vec3 sum = Vec3::Zero();
  for (const Halfedge h : corners)
  {
    sum += this->normalBeside(h);
  }
  const double length = normal.norm();
  return length > 0 ? sum.dot(normal) / (3. * length) : 1.;
}

std::vector<std::vector<int>> idsOf(const std::vector<OptimizedMesh::Chain>& chains)
{
  std::vector<std::vector<int>> ids;
  for (const OptimizedMesh::Chain& chain : chains)
  {
    ids.emplace_back();
    for (const BackboneVertex& v : chain)
    {
      ids.back().push_back(v.vertex.index());
    }
  }
  return ids;
}
}
