// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Overlaps: regions whose triangles cover the surface more than once, folded over or all of them
// facing the right way. Moves of one vertex at a time do not undo them; placing all vertices anew
// does.
#ifndef stipple_LocalEmbedding_h
#define stipple_LocalEmbedding_h

#include "MeshEdit.h"
#include "MeshRegion.h"
#include "StippleFiltersOptimizationModule.h"

#include <optional>
#include <vector>

namespace stipple
{
/// Puts every vertex to the middle of its neighbours (Tutte's embedding, on the surface: without
/// folds where the region is nearly flat), starting over from the vertices around; then swaps, if
/// it may, and moves for good angles. The vertices are free; `faces` are all triangles about them.
/// False if vertices were drawn off a part of the surface, which a few triangles then cut off: the
/// longest edge became much longer, or a place where a vertex was is farther from all triangles
/// there than half of the mean edge; or if a vertex came to lie on another.
STIPPLEFILTERSOPTIMIZATION_EXPORT bool embed(MeshEdit& edit, const std::vector<Vertex>& vertices,
  const std::vector<Face>& faces, bool maySwap);

/// Triangles that hang together at vertices, each group ascending.
STIPPLEFILTERSOPTIMIZATION_EXPORT std::vector<std::vector<Face>> groupsOf(
  const OptimizedMesh& mesh, const std::vector<Face>& faces);

/// Groups of triangles that no embedding helped, by their places: as long as they lie there, and so
/// many, another attempt would end as the last did.
class STIPPLEFILTERSOPTIMIZATION_EXPORT FailedEmbeddings
{
public:
  bool contains(const OptimizedMesh& mesh, const std::vector<Face>& faces) const;
  void add(const OptimizedMesh& mesh, const std::vector<Face>& faces);
  /// Triangles that may still be embedded, counted each time.
  int& budget(const OptimizedMesh& mesh);

private:
  struct Group
  {
    std::size_t size;
    Vec3 centre;
    double edge;
  };
  static Group groupOf(const OptimizedMesh& mesh, const std::vector<Face>& faces);
  std::vector<Group> Groups;
  std::optional<int> Budget;
};

/// Embeds the free vertices about triangles, of as few rings as make isBetter(after, before) true
/// of what measure(faces) says of the triangles changed. Returns these; none if no number of rings
/// helps, or is known not to.
template <typename Measure, typename IsBetter>
std::vector<Face> embedAbout(MeshEdit& edit, const std::vector<Face>& faces, int mostRings,
  bool maySwap, FailedEmbeddings& failed, const Measure& measure, const IsBetter& isBetter)
{
  const OptimizedMesh& mesh = edit.mesh();
  if (failed.contains(mesh, faces))
  {
    return {};
  }
  for (int rings = 0; rings <= mostRings; ++rings)
  {
    const std::vector<Vertex> vertices = filtered(withRings(mesh, cornersOf(mesh, faces), rings),
      [&](Vertex v) { return mesh.isFree(v) && !mesh.isBoundary(v); });
    if (vertices.empty())
    {
      continue;
    }
    const std::vector<Face> changed = facesAbout(mesh, vertices);
    const auto before = measure(changed);
    if (edit.attempt([&]() {
          return embed(edit, vertices, changed, maySwap) && isBetter(measure(changed), before);
        }))
    {
      return changed;
    }
  }
  failed.add(mesh, faces);
  return {};
}

/// Embeds the vertices about triangles that are folded over, of as few rings as undo most of it,
/// for half of what is left of the budget at most: there is always some for another time.
/// Returns the number of groups of triangles where that helped.
STIPPLEFILTERSOPTIMIZATION_EXPORT int unfold(
  MeshEdit& edit, bool maySwap, FailedEmbeddings& failed);
}

#endif
