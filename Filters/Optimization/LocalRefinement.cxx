// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalRefinement.h"

#include "LooseMesh.h"
#include "MeshRegion.h"
#include "Relaxation.h"
#include "Tuning.h"

#include <algorithm>
#include <cmath>

namespace stipple
{
namespace
{
class Refinement : public LooseMesh
{
public:
  explicit Refinement(const OptimizedMesh& mesh)
    : LooseMesh(mesh, 0.)
  {
  }

  /// Splits the widest edges where spacing has shrunk, until none is too wide. It ends: each pass
  /// takes spare vertices, and there are only so many of these and of passes.
  void split()
  {
    int made = 1;
    for (int pass = 0; pass < Tuning::PassesOfRefinement && made > 0; ++pass)
    {
      made = this->splitOnce();
    }
  }

  /// Vertices that went elsewhere, and those that were joined for it.
  std::vector<Vertex> changed() const
  {
    std::vector<Vertex> result = this->Placed;
    result.insert(result.end(), this->Joined.begin(), this->Joined.end());
    return result;
  }

private:
  /// Each triangle once.
  int splitOnce()
  {
    const double unit = this->Spacing.atUnitDensity();
    const double areaOfRegular = 1.5 * std::sqrt(3.) * unit * unit; // as areaOf() has it
    const std::size_t untouched = this->Now.triangles().size();
    std::vector<char> used(untouched, 0);
    int made = 0;
    for (const auto& [a, b] : this->widestEdges(untouched))
    {
      const auto besideEdge = [this, p = a, q = b]() { return this->Now.beside(p, q); };
      const std::vector<int> beside = besideEdge();
      const bool isWhole = beside.size() == 2 &&
        std::all_of(beside.begin(), beside.end(),
          [&](int t) { return t < static_cast<int>(untouched) && used[t] == 0; });
      if (!isWhole || (this->Mesh.fineness(a) == 1. && this->Mesh.fineness(b) == 1.))
      {
        continue;
      }
      const double area =
        this->areaOf(this->Now.triangle(beside[0])) + this->areaOf(this->Now.triangle(beside[1]));
      if (area < 2. * Tuning::WidestTriangle * areaOfRegular)
      {
        break; // and so are all others
      }
      const SurfacePoint middle = this->middle(a, b);
      if (!this->isBetween(middle.position, a, b) || !this->hasSpare() || besideEdge() != beside)
      {
        continue;
      }
      const Vertex v = this->takeSpare(middle, true);
      this->Density[v] = this->Mesh.densityAt(middle);
      if (!this->splitStaysApart(a, b, v))
      {
        this->Freed.push_back(v);
        continue;
      }
      std::for_each(beside.begin(), beside.end(), [&](int t) { used[t] = 1; });
      this->Placed.push_back(v);
      this->Now.split(a, b, v);
      ++this->NumberOfSwaps;
      ++made;
    }
    return made;
  }
};

/// Half as long as a triangle's edges are, at its middle.
void addRegion(
  const OptimizedMesh& mesh, const VertexSpacing& spacing, Face f, SpacingRegions& regions)
{
  const auto corners = mesh.corners(f);
  Vec3 centre = Vec3::Zero();
  double edge = 0;
  double unrefined = 0; // spacing
  for (std::size_t k = 0; k < corners.size(); ++k)
  {
    const Vertex v = corners[k];
    centre += mesh.position(v) / 3.;
    edge += (mesh.position(corners[(k + 1) % 3]) - mesh.position(v)).norm() / 3.;
    unrefined += spacing.at(v) / mesh.fineness(v) / 3.;
  }
  const auto* const free =
    std::find_if(corners.begin(), corners.end(), [&](Vertex v) { return mesh.isFree(v); });
  const Vertex from = free == corners.end() ? corners[0] : *free;
  const SurfacePoint there = mesh.walk(mesh.place(from), centre - mesh.position(from));
  regions.add(mesh.atlas().surface(), Face(there.place.face),
    { there.position, unrefined, std::min(1., Tuning::RefinedSpacing * edge / unrefined) });
}
}

Status refineAbout(
  OptimizedMesh& mesh, const std::vector<Face>& faces, std::vector<Vertex>& changed)
{
  SpacingRegions regions = mesh.fineRegions();
  const VertexSpacing spacing(mesh);
  for (const Face f : faces)
  {
    addRegion(mesh, spacing, f, regions);
  }
  changed = cornersOf(mesh, faces);
  mesh.refine(std::move(regions));
  Refinement refinement(mesh);
  refinement.split();
  const std::vector<Vertex> more = refinement.changed();
  changed.insert(changed.end(), more.begin(), more.end());
  makeUnique(changed);
  OptimizedMesh::Change change = refinement.finish();
  return change.swaps == 0 ? Status::success() : mesh.rebuild(std::move(change));
}
}
