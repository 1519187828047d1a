// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Creases that are rounded off: bands so narrow that a mesh may have no room for their curvature.
#ifndef stipple_RoundedEdges_h
#define stipple_RoundedEdges_h

#include "CutSurface.h"

namespace stipple
{
struct RoundedEdgeOptions
{
  double width = 0;         ///< of the widest band that counts as an edge, in units of length
  double angle = 100;       ///< degrees that the surface turns by across the band, at least
  double flank = 0.25;      ///< at most so much of that it turns by beside the band, over its width
  double minimumLength = 0; ///< of lines that hang together, in units of length
  double shortestBranch = 0; ///< of a line from where it ends, in units of length
};

/// Lines along the middle of narrow bands across which the surface turns by the angle or more: the
/// rim of a shell, the trailing edge of a wing, a lip. One halfedge of each of their edges.
///
/// The plane across an edge's middle cuts the surface in a curve. The edge is in the middle of a
/// band if that turns as much on its left as on its right, but for what it turns by at the edge
/// itself: by the angle or more within the width, or half, a quarter of it and so on, and by little
/// over as much again on both sides. Nothing is looked for beyond features. Edges whose ends are no
/// farther apart than their bands are wide are joined along edges; what closes a cycle shorter than
/// a few widths, or is a spur or a line no longer than that, is left out.
STIPPLEFILTERSATLAS_EXPORT std::vector<Halfedge> findRoundedEdges(
  const CutSurface& surface, const RoundedEdgeOptions& options);

/// Tells backbones along rounded edges how wide their bands are that turn by the angle: as wide as
/// half of the line's edges say, in its length, of all that hang together. Where that is more than
/// the options' width, it is infinite.
STIPPLEFILTERSATLAS_EXPORT void measureRoundedEdges(
  const CutSurface& surface, const RoundedEdgeOptions& options, FeatureGraph& graph);
}

#endif
