// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OptimizedMesh.h"

#include "MeshCreation.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <utility>

namespace stipple
{
namespace
{
/// The height of a triangle is at least this share of its longest edge.
constexpr double MinimumHeight = 0.02;
constexpr int Grain = 512;
/// A constraint and the point that it became lie this share of the diagonal apart at most.
constexpr double ConstraintTolerance = 1e-8;

/// Tells the points that constraints became, also on backbones, where their samples are of a
/// backbone's kind.
class ConstraintFinder
{
public:
  explicit ConstraintFinder(const SurfaceCache& atlas)
  {
    const AtlasSurface& surface = atlas.surface();
    for (const ConstraintPoint& c : atlas.graph().constraints)
    {
      this->Places.push_back(surface.position(surface.chartBegin[c.chart] + c.chartCell, c.bary));
    }
    std::sort(this->Places.begin(), this->Places.end(),
      [](const Vec3& a, const Vec3& b) { return a.x() < b.x(); });
    this->Reach = this->Places.empty() ? 0. : ConstraintTolerance * surface.boundingBoxDiagonal();
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

Status OptimizedMesh::build(const SurfaceCache& atlas, const DensityField& density,
  const std::vector<Sample>& samples, const std::vector<Triangle>& triangles)
{
  this->Atlas = &atlas;
  this->Field = &density;
  this->Original = samples;
  const int n = static_cast<int>(samples.size());
  const FeatureGraph& graph = atlas.graph();
  this->Place.resize(n);
  this->Position.resize(n);
  this->Normal.resize(n);
  this->Behind.assign(n, Vec3::Zero());
  this->Density.assign(n, 1.);
  this->Free.assign(n, Freedom::Surface);
  this->BackboneOf.assign(n, -1);
  this->ArcLength.assign(n, 0.);
  // Corners, also tips of cones that a seam runs through, and where sharp and boundary backbones
  // end.
  std::vector<char> fixedNode = graph.isCorner;
  fixedNode.resize(atlas.surface().points.size(), 0);
  for (const Backbone& b : graph.backbones)
  {
    if (!b.closed && b.type != BackboneType::Seam)
    {
      fixedNode[b.points.front()] = fixedNode[b.points.back()] = 1;
    }
  }
  const ConstraintFinder constraints(atlas);
  for (int v = 0; v < n; ++v)
  {
    const Sample& s = samples[v];
    this->placeVertex(v, { s.face, s.bary });
    const bool constrained =
      s.kind != SampleKind::Interior && constraints.isConstraint(this->Position[v]);
    if (s.kind == SampleKind::Constraint ||
      (s.kind == SampleKind::Corner && s.surfacePoint >= 0 && fixedNode[s.surfacePoint]))
    {
      this->Free[v] = Freedom::None;
    }
    else if (s.kind == SampleKind::Backbone)
    {
      if (s.backbone < 0 || s.backbone >= static_cast<int>(graph.backbones.size()))
      {
        return Status::error("Point " + std::to_string(v) + " lies on backbone " +
          std::to_string(s.backbone) +
          ", which the feature graph does not have: pass the one of the mesh.");
      }
      if (graph.backbones[s.backbone].type != BackboneType::Seam)
      {
        this->Free[v] = constrained ? Freedom::None : Freedom::Backbone;
        this->BackboneOf[v] = s.backbone;
        this->ArcLength[v] = s.arcLength;
        this->lookBehind(v);
        continue;
      }
    }
    if (constrained && this->Free[v] == Freedom::Surface) // on a seam, which heals
    {
      this->Free[v] = Freedom::None;
      this->Original[v] = { SampleKind::Constraint, s.face, s.bary, -1, 0., -1 };
    }
  }
  Status status = this->connect(triangles);
  return status.ok() ? this->markFeatures() : status;
}

/// Fills OpenMesh's arrays directly: faster than add_face(), and independent of the order of the
/// triangles.
Status OptimizedMesh::connect(const std::vector<Triangle>& triangles)
{
  const auto twin = halfedgeTwins(triangles);
  const int n = static_cast<int>(triangles.size());
  this->Graph.clear();
  this->Graph.reserve(this->Position.size(), twin.size() / 2 + 1, triangles.size());
  for (std::size_t v = 0; v < this->Position.size(); ++v)
  {
    this->Graph.new_vertex();
  }
  std::vector<Halfedge> own(twin.size());
  const auto tail = [&](int h) { return triangles[h / 3][h % 3]; };
  std::vector<Halfedge> outside(this->Position.size()); // boundary halfedge out of a vertex
  for (int h = 0; h < 3 * n; ++h)
  {
    if (twin[h] == -2)
    {
      return Status::error("The mesh's edge between the points " + std::to_string(tail(h)) +
        " and " + std::to_string(tail(nextHalfedge(h))) +
        " is not manifold or not consistently oriented: pass the output of vtkCDTRemesh.");
    }
    if (twin[h] > h || twin[h] < 0)
    {
      own[h] = this->Graph.new_edge(Vertex(tail(h)), Vertex(tail(nextHalfedge(h))));
      const Halfedge opposite = this->Graph.opposite_halfedge_handle(own[h]);
      if (twin[h] >= 0)
      {
        own[twin[h]] = opposite;
      }
      else
      {
        this->Graph.set_boundary(opposite);
        outside[tail(nextHalfedge(h))] = opposite;
      }
    }
  }
  for (int f = 0; f < n; ++f)
  {
    const auto face = this->Graph.new_face();
    this->Graph.set_halfedge_handle(face, own[3 * f]);
    for (int k = 0; k < 3; ++k)
    {
      const int h = 3 * f + k;
      this->Graph.set_face_handle(own[h], face);
      this->Graph.set_next_halfedge_handle(own[h], own[nextHalfedge(h)]);
      this->Graph.set_halfedge_handle(Vertex(triangles[f][k]), own[h]);
    }
  }
  for (const Halfedge h : outside)
  {
    if (h.is_valid())
    {
      this->Graph.set_next_halfedge_handle(h, outside[this->Graph.to_vertex_handle(h).idx()]);
      this->Graph.set_halfedge_handle(this->Graph.from_vertex_handle(h), h);
    }
  }
  for (std::size_t v = 0; v < this->Position.size(); ++v)
  {
    if (!this->Graph.halfedge_handle(Vertex(static_cast<int>(v))).is_valid())
    {
      return Status::error("Point " + std::to_string(v) +
        " of the mesh is in no triangle: pass the output of vtkCDTRemesh.");
    }
  }
  return Status::success();
}

Status OptimizedMesh::markFeatures()
{
  this->Feature.assign(this->Graph.n_edges(), 0);
  this->Chain = backboneChains(this->Atlas->graph(), this->Original);
  for (std::size_t b = 0; b < this->Chain.size(); ++b)
  {
    std::vector<int>& chain = this->Chain[b];
    if (this->Atlas->graph().backbones[b].type == BackboneType::Seam)
    {
      chain.clear();
    }
    for (std::size_t i = 1; i < chain.size(); ++i)
    {
      const Halfedge h = this->Graph.find_halfedge(Vertex(chain[i - 1]), Vertex(chain[i]));
      if (!h.is_valid())
      {
        return Status::error("The mesh has no edge between the points " +
          std::to_string(chain[i - 1]) + " and " + std::to_string(chain[i]) +
          ", neighbours on backbone " + std::to_string(b) +
          ": pass the output of vtkCDTRemesh and its feature graph.");
      }
      this->Feature[this->Graph.edge_handle(h).idx()] = 1;
    }
  }
  return Status::success();
}

void OptimizedMesh::placeVertex(int v, const SurfacePlace& place)
{
  this->Place[v] = place;
  this->Position[v] = this->Atlas->surface().position(place.face, place.bary);
  this->Normal[v] = this->Atlas->smoothNormal(place.face);
  this->Density[v] = this->densityAt(place, this->Position[v]);
}

double OptimizedMesh::densityAt(const SurfacePlace& place, const Vec3& position) const
{
  const double density =
    this->Field->uniform() ? 1. : this->Field->at(this->Atlas->surface(), place);
  if (this->Coarse.empty())
  {
    return density;
  }
  const double growth = this->Coarse.growthAt(place.face, position);
  return density / (growth * growth);
}

void OptimizedMesh::coarsen(CoarseRegions regions)
{
  this->Coarse = std::move(regions);
  for (int v = 0; v < this->numberOfVertices(); ++v)
  {
    this->Density[v] = this->densityAt(this->Place[v], this->Position[v]);
  }
}

void OptimizedMesh::placeOnBackbone(int v, double arcLength)
{
  const double length = this->Atlas->traces()[this->BackboneOf[v]].length();
  if (this->Atlas->graph().backbones[this->BackboneOf[v]].closed)
  {
    arcLength -= length * std::floor(arcLength / length);
  }
  this->ArcLength[v] = arcLength;
  this->placeVertex(v, this->Atlas->placeOfBackbone(this->BackboneOf[v], arcLength));
  this->lookBehind(v);
}

void OptimizedMesh::lookBehind(int v)
{
  if (this->BackboneOf[v] < 0)
  {
    return;
  }
  this->Behind[v] = this->Normal[v];
  const BackboneTrace& trace = this->Atlas->traces()[this->BackboneOf[v]];
  if (trace.chart[0] >= 0 && trace.chart[1] >= 0)
  {
    const BackboneTrace::Place place = trace.locate(this->ArcLength[v]);
    const int side = this->Place[v].face == trace.face(place, 1) ? 0 : 1;
    this->Behind[v] = this->Atlas->smoothNormal(trace.face(place, side));
  }
}

int OptimizedMesh::valence(int v) const
{
  int n = 0;
  this->forEachHalfedge(v, [&n](Halfedge) { ++n; });
  return n;
}

std::vector<Triangle> OptimizedMesh::triangles() const
{
  std::vector<Triangle> result(this->Graph.n_faces());
  for (std::size_t f = 0; f < result.size(); ++f)
  {
    Halfedge h = this->Graph.halfedge_handle(OpenMesh::FaceHandle(static_cast<int>(f)));
    for (int k = 0; k < 3; ++k, h = this->Graph.next_halfedge_handle(h))
    {
      result[f][k] = this->Graph.from_vertex_handle(h).idx();
    }
    // Whatever swaps did to the halfedges: the smallest point comes first.
    std::rotate(
      result[f].begin(), std::min_element(result[f].begin(), result[f].end()), result[f].end());
  }
  return result;
}

std::vector<Sample> OptimizedMesh::samples() const
{
  std::vector<Sample> result = this->Original;
  for (int v = 0; v < this->numberOfVertices(); ++v)
  {
    Sample& s = result[v];
    s.face = this->Place[v].face;
    s.bary = this->Place[v].bary;
    s.arcLength = this->ArcLength[v];
    if (this->Free[v] == Freedom::Surface) // seams have healed: nothing tells their samples from
                                           // others
    {
      s = { SampleKind::Interior, s.face, s.bary, -1, 0., -1 };
    }
  }
  return result;
}

bool OptimizedMesh::isSound(int a, int b, int c) const
{
  const Vec3& p = this->Position[a];
  const Vec3& q = this->Position[b];
  const Vec3& r = this->Position[c];
  const Vec3 n = (q - p).cross(r - p);
  const double area = n.norm();
  const double longest =
    std::max({ (q - p).squaredNorm(), (r - q).squaredNorm(), (p - r).squaredNorm() });
  if (!(area > MinimumHeight * longest))
  {
    return false;
  }
  const bool isOnCreases = this->Free[a] != Freedom::Surface && this->Free[b] != Freedom::Surface &&
    this->Free[c] != Freedom::Surface;
  return (isOnCreases ? this->agreementOnCreases(a, b, c, n) : this->agreement(a, b, c, n)) >=
    minimumAgreement();
}

double OptimizedMesh::agreementOnCreases(int a, int b, int c, const Vec3& normal) const
{
  double sum = 0;
  int count = 0;
  for (int v : { a, b, c })
  {
    if (this->BackboneOf[v] >= 0)
    {
      sum += std::max(normal.dot(this->Normal[v]), normal.dot(this->Behind[v]));
      ++count;
    }
  }
  const double length = normal.norm();
  return count > 0 && length > 0 ? sum / (count * length) : 1.;
}

double OptimizedMesh::agreement(int a, int b, int c, const Vec3& normal) const
{
  double sum = 0;
  int count = 0;
  for (int v : { a, b, c })
  {
    if (this->Free[v] == Freedom::Surface) // on a crease the surface has no one normal
    {
      sum += normal.dot(this->Normal[v]);
      ++count;
    }
  }
  const double length = normal.norm();
  return count > 0 && length > 0 ? sum / (count * length) : 1.;
}

bool OptimizedMesh::isSoundFace(int f) const
{
  const auto t = this->corners(f);
  return this->isSound(t[0], t[1], t[2]);
}

bool OptimizedMesh::swap(int edge)
{
  const OpenMesh::EdgeHandle e(edge);
  if (!this->isSwappable(edge) || !this->Graph.is_flip_ok(e))
  {
    return false;
  }
  const Halfedge h = this->Graph.halfedge_handle(e, 0);
  const Halfedge g = this->Graph.halfedge_handle(e, 1);
  const int a = this->Graph.from_vertex_handle(h).idx();
  const int b = this->Graph.to_vertex_handle(h).idx();
  const int c = this->Graph.to_vertex_handle(this->Graph.next_halfedge_handle(h)).idx();
  const int d = this->Graph.to_vertex_handle(this->Graph.next_halfedge_handle(g)).idx();
  const int after = this->isSound(d, c, a) + this->isSound(c, d, b);
  if (after < 2 && after < this->isSound(a, b, c) + this->isSound(b, a, d))
  {
    return false;
  }
  this->Graph.flip(e);
  return true;
}

void OptimizedMesh::move(std::vector<Vec3>& step, const std::vector<double>& arcLength)
{
  const int n = this->numberOfVertices();
  const int faces = this->numberOfFaces();
  std::vector<SurfacePlace>& oldPlace = this->Before.place; // kept for their memory only
  std::vector<double>& oldArcLength = this->Before.arcLength;
  std::vector<Vec3>& oldPosition = this->Before.position;
  std::vector<Vec3>& oldNormal = this->Before.normal;
  std::vector<Vec3>& oldBehind = this->Before.behind;
  oldPlace = this->Place;
  oldArcLength = this->ArcLength;
  oldPosition = this->Position;
  oldNormal = this->Normal;
  oldBehind = this->Behind;
  std::vector<float> share(n, 1.f);
  std::vector<int> drawnBack;
  const auto forget = [&]() {
    for (int v : drawnBack) // no momentum into what was refused
    {
      step[v] = Vec3::Zero();
    }
  };
  const auto moveVertex = [&](int v) {
    if (this->Free[v] == Freedom::Surface)
    {
      this->placeVertex(
        v, share[v] > 0 ? this->Atlas->walk().walk(oldPlace[v], share[v] * step[v]) : oldPlace[v]);
    }
    else if (this->Free[v] == Freedom::Backbone)
    {
      this->placeOnBackbone(v, oldArcLength[v] + share[v] * (arcLength[v] - oldArcLength[v]));
    }
  };
  vtkSMPTools::For(0, n, Grain, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType v = begin; v < end; ++v)
    {
      moveVertex(static_cast<int>(v));
    }
  });
  // Triangles that are unsound now, and were not, draw their vertices back: to a half, a quarter,
  // at last all the way.
  std::vector<char> isSoundNow(faces);
  for (int round = 0; round < 12; ++round)
  {
    vtkSMPTools::For(0, faces, Grain, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType f = begin; f < end; ++f)
      {
        isSoundNow[f] = this->isSoundFace(static_cast<int>(f));
      }
    });
    // Most rounds end here; only now look back at how the few were before.
    std::vector<int> unsound;
    for (int f = 0; f < faces; ++f)
    {
      if (!isSoundNow[f])
      {
        unsound.push_back(f);
      }
    }
    this->Position.swap(oldPosition);
    this->Normal.swap(oldNormal);
    this->Behind.swap(oldBehind);
    std::vector<int> back;
    for (int f : unsound)
    {
      Halfedge h = this->Graph.halfedge_handle(OpenMesh::FaceHandle(f));
      for (int k = 0; k < 3 && this->isSoundFace(f); ++k, h = this->Graph.next_halfedge_handle(h))
      {
        back.push_back(this->Graph.to_vertex_handle(h).idx());
      }
    }
    this->Position.swap(oldPosition);
    this->Normal.swap(oldNormal);
    this->Behind.swap(oldBehind);
    if (back.empty())
    {
      forget();
      return;
    }
    makeUnique(back);
    for (int v : back)
    {
      share[v] = round < 2 ? 0.5f * share[v] : 0.f;
      moveVertex(v);
      drawnBack.push_back(v);
    }
  }
  forget();
  // Drawing back spread on and on: take back the whole step.
  std::fill(share.begin(), share.end(), 0.f);
  for (int v = 0; v < n; ++v)
  {
    moveVertex(v);
  }
}

Footing OptimizedMesh::footing(const SurfacePlace& from, const Vec3& step) const
{
  Footing there;
  there.place = this->Atlas->walk().walk(from, step);
  there.position = this->Atlas->surface().position(there.place.face, there.place.bary);
  there.normal = this->Atlas->smoothNormal(there.place.face);
  return there;
}

void OptimizedMesh::put(int v, const Footing& there)
{
  this->stand(v, there);
  this->Density[v] = this->densityAt(there.place, there.position);
}

bool OptimizedMesh::hasRoom(int v, double step) const
{
  if (this->Free[v] != Freedom::Backbone)
  {
    return false;
  }
  double room = 1e300; // to its neighbours on the backbone
  this->forEachHalfedge(v, [&](Halfedge h) {
    if (this->Feature[this->Graph.edge_handle(h).idx()])
    {
      room = std::min(
        room, (this->Position[this->Graph.to_vertex_handle(h).idx()] - this->Position[v]).norm());
    }
  });
  const double length = this->Atlas->traces()[this->BackboneOf[v]].length();
  const double target = this->ArcLength[v] + step;
  const bool closed = this->Atlas->graph().backbones[this->BackboneOf[v]].closed;
  return std::abs(step) <= 0.5 * room && (closed || (target > 0 && target < length));
}
}
