// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Regular quads in the parameter planes of the charts (paper 5, Figure 1).
#ifndef stipple_QuadPattern_h
#define stipple_QuadPattern_h

#include "Atlas.h"
#include "DensityField.h"
#include "SampleSet.h"
#include "StippleFiltersPatternsModule.h"

#include <array>
#include <vector>

namespace stipple
{
struct QuadMesh
{
  std::vector<Sample> samples;
  std::vector<std::vector<int>> polygons; ///< quads and triangles, oriented like the surface
  std::vector<std::vector<int>> chains;   ///< samples along backbones, by backbone
  int numberOfSimplifiedFeatures = 0;     ///< as OptimizedMesh counts them
};

struct LatticeSamples
{
  std::vector<Sample> samples;
  std::vector<std::array<int, 4>> cells; ///< samples at their corners, or -1 where there is none
};

/// The samples inside every chart give way to the nodes of a square lattice that keep clear of the
/// backbones, as many as fit, and the samples farthest from them for the rest; the lattice is
/// halved where the chart's map stretches the surface, and where the density asks for it
/// (GradedLattice.h). Samples on backbones and constraints stay, and come first.
STIPPLEFILTERSPATTERNS_EXPORT Status placeOnLattices(const Atlas& atlas,
  const std::vector<Sample>& samples, LatticeSamples& result, const Progress& progress,
  const DensityField& density = {});

/// A surface that is one chart, bounded by its outline alone, becomes quads only where the density
/// is the same everywhere: a grid over the rectangle with at most as many nodes as there are
/// samples, if its cells are about squares on the surface but for the four at its corners, which
/// may be two triangles each.
/// Elsewhere quads are the cells of placeOnLattices() that are about squares on the
/// surface and about as large as wanted. Where sizes differ, along features and where charts meet
/// are triangles; of these, the samples that are no square's corners are optimised: they move, on
/// their creases if they are on some, and edges are swapped. Features may move by the tolerance
/// (see OptimizerOptions).
STIPPLEFILTERSPATTERNS_EXPORT Status meshWithQuads(const Atlas& atlas,
  const std::vector<Sample>& samples, QuadMesh& mesh, const Progress& progress,
  const DensityField& density = {}, double featureTolerance = 1.);
}

#endif
