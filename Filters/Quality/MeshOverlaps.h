// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Where a mesh passes through itself and the surface that it is of does not.
#ifndef stipple_MeshOverlaps_h
#define stipple_MeshOverlaps_h

#include "Progress.h"
#include "StippleFiltersQualityModule.h"
#include "TriangleIntersections.h"
#include "TriangleSurface.h"

#include <array>
#include <functional>
#include <vector>

namespace stipple
{
/// Two triangles of a mesh that pass through each other.
struct MeshOverlap
{
  std::array<Face, 2> faces;
  Vec3 position; ///< in the middle of what the boxes about both have in common
};

/// Pairs of triangles as countSelfIntersections() counts them, without those that are no farther
/// than triangles are large in the mean from where the surface passes through itself (`known`,
/// asked for if there are any pairs). In an order of their own, the same for any number of threads;
/// of no use if stopped.
[[nodiscard]] STIPPLEFILTERSQUALITY_EXPORT std::vector<MeshOverlap> findOverlaps(
  const TriangleSurface& mesh, const std::function<std::vector<Box>()>& known,
  const Stop& stop = {});
}

#endif
