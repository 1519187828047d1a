// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SelfIntersections.h"

#include "LocalEmbedding.h"
#include "MeshCrossings.h"
#include "MeshRegion.h"
#include "Relaxation.h"
#include "Tuning.h"
#include "VertexStar.h"

#include <algorithm>

namespace stipple
{
struct SelfIntersections::Internals
{
  const OptimizedMesh& Mesh;
  BoxGrid Grid; // of faces, as last updated
  /// Faces that a face intersects, in no order; of both the other is one.
  ElementArray<Face, std::vector<Face>> Partners;

  explicit Internals(const OptimizedMesh& mesh)
    : Mesh(mesh)
    , Partners(static_cast<std::size_t>(mesh.faces().size()))
  {
    std::vector<Box> boxes;
    for (const Face f : mesh.faces())
    {
      boxes.push_back(this->boxOf(f));
    }
    this->Grid = BoxGrid(std::move(boxes));
    for (const auto& [f, g] : this->Grid.pairs([&](int i, int j) {
           return intersect(mesh, mesh.corners(Face(i)), mesh.corners(Face(j)));
         }))
    {
      this->join(Face(f), Face(g));
    }
  }
  Box boxOf(Face f) const { return placed(this->Mesh, this->Mesh.corners(f)).box(); }
  void join(Face f, Face g)
  {
    this->Partners[f].push_back(g);
    this->Partners[g].push_back(f);
  }
  void part(Face f)
  {
    for (const Face g : this->Partners[f])
    {
      std::vector<Face>& others = this->Partners[g];
      others.erase(std::find(others.begin(), others.end(), f));
    }
    this->Partners[f].clear();
  }
};

SelfIntersections::SelfIntersections(const OptimizedMesh& mesh)
  : Now(std::make_unique<Internals>(mesh))
{
}

SelfIntersections::~SelfIntersections() = default;

int SelfIntersections::count(const std::vector<Face>& faces) const
{
  Internals& now = *this->Now;
  std::vector<Face> inOrder = faces;
  std::sort(inOrder.begin(), inOrder.end());
  std::vector<Box> boxes;
  int pairs = 0;
  for (const Face f : faces)
  {
    const auto t = now.Mesh.corners(f);
    const Box box = now.boxOf(f);
    now.Grid.forEachNear(box, [&](int g) {
      if (!std::binary_search(inOrder.begin(), inOrder.end(), Face(g)))
      {
        pairs += intersect(now.Mesh, t, now.Mesh.corners(Face(g))) ? 1 : 0;
      }
    });
    for (std::size_t j = 0; j < boxes.size(); ++j)
    {
      if (box.overlaps(boxes[j]))
      {
        pairs += intersect(now.Mesh, t, now.Mesh.corners(faces[j])) ? 1 : 0;
      }
    }
    boxes.push_back(box);
  }
  return pairs;
}

void SelfIntersections::update(const std::vector<Face>& faces)
{
  Internals& now = *this->Now;
  for (const Face f : faces)
  {
    now.Grid.move(f.index(), now.boxOf(f));
    now.part(f);
  }
  for (const Face f : faces)
  {
    const auto t = now.Mesh.corners(f);
    now.Grid.forEachNear(now.Grid.box(f.index()), [&](int i) {
      const Face g(i);
      const std::vector<Face>& partners = now.Partners[f];
      if (g != f && std::find(partners.begin(), partners.end(), g) == partners.end() &&
        intersect(now.Mesh, t, now.Mesh.corners(g)))
      {
        now.join(f, g);
      }
    });
  }
}

std::vector<Face> SelfIntersections::faces() const
{
  std::vector<Face> result;
  for (const Face f : this->Now->Mesh.faces())
  {
    if (!this->Now->Partners[f].empty())
    {
      result.push_back(f);
    }
  }
  return result;
}

double SelfIntersections::meanSize() const
{
  return this->Now->Grid.meanSize();
}

bool SelfIntersections::isNear(Face face, BoxGrid& boxes) const
{
  const BoxGrid& grid = this->Now->Grid;
  return boxes.hasNear(grid.box(face.index()).grown(grid.meanSize()));
}

namespace
{
bool partByMove(MeshEdit& edit, SelfIntersections& intersections, Vertex v)
{
  const OptimizedMesh& mesh = edit.mesh();
  const std::vector<Face> faces = facesAbout(mesh, { v });
  int best = intersections.count(faces);
  if (best == 0)
  {
    return false;
  }
  const VertexStar star(mesh, v);
  const double quality = std::min(Tuning::PartingAngle, star.quality(mesh.state(v)));
  bool changed = false;
  const auto isBetter = [&]() {
    if (best == 0 || star.quality(mesh.state(v)) < quality)
    {
      return false;
    }
    const int now = intersections.count(faces);
    if (now >= best)
    {
      return false;
    }
    best = now;
    intersections.update(faces);
    changed = true;
    return true;
  };
  const auto tryStep = [&](const Vec3& step) {
    if (best > 0)
    {
      edit.tryPut(v, mesh.walk(mesh.place(v), step), isBetter);
    }
  };
  const double reach = meanEdgeLength(mesh, v);
  for (const double size : Tuning::PartingSizes)
  {
    if (mesh.freedom(v) == Freedom::Backbone)
    {
      edit.trySlide(v, size * reach, isBetter);
      edit.trySlide(v, -size * reach, isBetter);
    }
    for (int k = 0; k < 8 && best > 0 && mesh.isFree(v); ++k)
    {
      tryStep(edit.stepsAround(v, size * reach)[k]); // from where it stands by now
    }
  }
  return changed;
}

bool partBySwap(MeshEdit& edit, SelfIntersections& intersections, Edge e)
{
  const OptimizedMesh& mesh = edit.mesh();
  if (!mesh.isSwappable(e))
  {
    return false;
  }
  const std::vector<Face> faces = { mesh.face(mesh.halfedge(e, 0)),
    mesh.face(mesh.halfedge(e, 1)) };
  const int before = intersections.count(faces);
  const double quality = std::min(Tuning::PartingAngle, worstQuality(mesh, faces));
  const bool isBetter = before > 0 && edit.attempt([&]() {
    return edit.swap(e) && worstQuality(mesh, faces) >= quality &&
      intersections.count(faces) < before;
  });
  if (isBetter)
  {
    intersections.update(faces);
  }
  return isBetter;
}

/// Where much of a mesh passes through itself, sheets are closer together than edges are long: then
/// there is nothing to part, and trying takes long.
int mostOverlaps(const OptimizedMesh& mesh)
{
  return Tuning::FewIntersecting + mesh.faces().size() / 50;
}

/// Places the vertices about the triangles anew, of as few rings as part any.
bool partByEmbedding(MeshEdit& edit, SelfIntersections& intersections,
  const std::vector<Face>& faces, int& budget, FailedEmbeddings& failed)
{
  struct State
  {
    int intersecting;
    double quality;
  };
  const std::vector<Face> changed = embedAbout(
    edit, faces, Tuning::RingsOfParting, true, failed,
    [&](const std::vector<Face>& now) {
      budget -= static_cast<int>(now.size());
      return State{ intersections.count(now), worstQuality(edit.mesh(), now) };
    },
    [&](const State& after, const State& before) {
      return after.intersecting < before.intersecting &&
        after.quality >= std::min(Tuning::PartingAngle, before.quality);
    });
  intersections.update(changed);
  return !changed.empty();
}
}

std::vector<Face> overlapsOf(
  const OptimizedMesh& mesh, const SelfIntersections& intersections, KnownOverlaps& known)
{
  std::vector<Face> faces = intersections.faces();
  if (faces.empty())
  {
    return faces;
  }
  if (!known.ofSurface)
  {
    known.ofSurface.emplace(mesh.atlas().selfIntersections(), intersections.meanSize());
  }
  return filtered(faces, [&](Face f) { return !intersections.isNear(f, *known.ofSurface); });
}

int resolveSelfIntersections(MeshEdit& edit, int maximumNumberOfPasses, KnownOverlaps& known)
{
  const OptimizedMesh& mesh = edit.mesh();
  SelfIntersections intersections(mesh);
  std::vector<Face> bad = overlapsOf(mesh, intersections, known);
  if (static_cast<int>(bad.size()) > mostOverlaps(mesh))
  {
    known.left = static_cast<int>(bad.size());
    return *known.left;
  }
  bool hasChanged = false;
  int& budget = known.layers.budget(mesh);
  for (int pass = 0; pass < maximumNumberOfPasses && !bad.empty(); ++pass)
  {
    bool changed = false;
    for (const Face f : bad)
    {
      for (const Vertex v : mesh.corners(f))
      {
        changed = partByMove(edit, intersections, v) || changed;
      }
      Halfedge h = mesh.halfedge(f);
      for (int k = 0; k < 3; ++k, h = mesh.next(h))
      {
        if (partBySwap(edit, intersections, mesh.edge(h)))
        {
          changed = true;
          break; // the triangle is another one now
        }
      }
    }
    bad = overlapsOf(mesh, intersections, known);
    // What is left then lies in layers that face the same way.
    if (pass > 0 || !changed)
    {
      for (const std::vector<Face>& group : groupsOf(mesh, bad))
      {
        changed =
          (budget > 0 && partByEmbedding(edit, intersections, group, budget, known.layers)) ||
          changed;
      }
    }
    if (!changed)
    {
      break;
    }
    hasChanged = true;
    bad = overlapsOf(mesh, intersections, known);
  }
  // Of layers that were parted, triangles may be left that are folded onto their neighbours.
  const std::size_t left = intersections.faces().size();
  if (hasChanged)
  {
    edit.attempt([&]() {
      return unfold(edit, true, known.folds) > 0 && SelfIntersections(mesh).faces().size() <= left;
    });
  }
  known.left = static_cast<int>(bad.size());
  return *known.left;
}
}
