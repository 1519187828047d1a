// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Regular quads in the parameter planes of the charts (paper 5, Figure 1).
#ifndef stipple_QuadPattern_h
#define stipple_QuadPattern_h

#include "Atlas.h"
#include "DensityField.h"
#include "SampleSet.h"
#include "StippleFiltersPatternsModule.h"

namespace stipple
{
struct QuadMesh
{
  std::vector<Sample> samples;
  std::vector<std::vector<int>> polygons; ///< quads and triangles, oriented like the surface
};

/// A surface that is one chart, bounded by its outline alone, becomes quads only where the density
/// is the same everywhere: a grid over the rectangle with at most as many nodes as there are
/// samples. Elsewhere the samples inside every
/// chart give way to the nodes of a square lattice that keep clear of the backbones, as many as fit
/// and the samples farthest from them for the rest; the lattice is halved where the chart's map
/// stretches the surface, and where the density asks for it (GradedLattice.h), and sizes differ by
/// triangles between them. Samples on backbones and constraints stay, so that charts meet along
/// seams in triangles and the number of samples is kept.
STIPPLEFILTERSPATTERNS_EXPORT Status meshWithQuads(const Atlas& atlas,
  const std::vector<Sample>& samples, QuadMesh& mesh, const Progress& progress,
  const DensityField& density = {});
}

#endif
