// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The schedule of the optimisation: swaps and moves in turn (paper 4.4).
#ifndef stipple_MeshOptimizer_h
#define stipple_MeshOptimizer_h

#include "OptimizedMesh.h"
#include "StippleFiltersOptimizationModule.h"

namespace stipple
{
struct OptimizerOptions
{
  enum class Swaps
  {
    None,
    Regularity,
    Aspect
  };
  enum class Moves
  {
    None,
    Area,
    Density,
    Lloyd
  };
  Swaps swaps = Swaps::Regularity;
  Moves moves = Moves::Lloyd;
  int iterations = 42; ///< >= 0; 0 changes nothing
  /// Share of the vertices, 0 to 1, about which moves at the end bring the mesh nearer to the
  /// surface: those with the farthest points of the surface.
  double errorReduction = 0.0065;
  /// Two neighbours on each side for vertices on sharp and boundary backbones (Figure 8), at the
  /// cost of smaller angles.
  bool ribs = false;
  /// Smallest angle, radians, that a triangle between two creases gets by spacing that grows
  /// towards their corner, where they open that far within 3.4 edges; 0: spacing does not grow. For
  /// Moves::Lloyd.
  double acuteCornerAngle = 0.436;
  /// How far features may go to others for the sake of triangles, 0 to 1 in units of the spacing
  /// (see simplifyFeatures()); 0: they are kept. For moves with swaps. With ribs, which want
  /// features as they are, only for slivers, and not when ribs are made.
  double featureTolerance = 1.;
  /// Edges get shorter than the density has them where the mesh passes through itself and the
  /// surface does not, or has poor triangles, and longer elsewhere (see LocalRefinement.h). For
  /// moves with swaps and a tolerance of features; not with ribs.
  bool refinesFaults = true;
  /// Creases that are none to the mesh are given up (see UnsteadyCreases.h), unless that leaves it
  /// visibly farther from the surface. For moves with swaps and a tolerance of features.
  bool givesUpCreases = true;
};

STIPPLEFILTERSOPTIMIZATION_EXPORT Status optimizeMesh(
  OptimizedMesh& mesh, const OptimizerOptions& options, const Progress& progress);
}

#endif
