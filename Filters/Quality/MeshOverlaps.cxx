// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshOverlaps.h"

#include "BoxGrid.h"
#include "TriangleIntersections.h"

namespace stipple
{
std::vector<MeshOverlap> findOverlaps(
  const TriangleSurface& mesh, const std::function<std::vector<Box>()>& known, const Stop& stop)
{
  const auto placed = [&](int f) {
    const Triangle& t = mesh.triangles[f];
    return PlacedTriangle{ t, { mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]] } };
  };
  std::vector<Box> boxes;
  boxes.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles)
  {
    boxes.push_back(Box::around(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]));
  }
  BoxGrid grid(std::move(boxes));
  const std::vector<std::array<int, 2>> pairs =
    grid.pairs([&](int i, int j) { return !isAsked(stop) && intersect(placed(i), placed(j)); });
  std::vector<MeshOverlap> overlaps;
  if (pairs.empty() || isAsked(stop))
  {
    return overlaps;
  }
  BoxGrid ofSurface(known(), grid.meanSize());
  for (const auto& [i, j] : pairs)
  {
    const Box place = grid.box(i).common(grid.box(j));
    if (!ofSurface.hasNear(place.grown(grid.meanSize())))
    {
      overlaps.push_back({ { { Face(i), Face(j) } }, 0.5 * (place.low + place.high) });
    }
  }
  return overlaps;
}
}
