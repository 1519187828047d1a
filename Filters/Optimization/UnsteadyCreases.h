// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Creases that are none to a mesh: on scans, folds are sharp to the input's edges, but to a mesh's
// they are much like the surface beside them. Those that poor triangles lie along are given up.
#ifndef stipple_UnsteadyCreases_h
#define stipple_UnsteadyCreases_h

#include "OptimizedMesh.h"
#include "StippleFiltersOptimizationModule.h"
#include "Tuning.h"

namespace stipple
{
/// How a surface bends across a backbone, to a mesh with edges of a length.
struct CreaseProfile
{
  double bend = 0; ///< mean angle, in radians, between the normals beside it
  /// Of the angle between the normals half the length away on both sides: the mean distance from
  /// the mean of those a third of the length before and after. What was made with an edge bends in
  /// the same way all along it, or fades out; a scan does not.
  double unsteadiness = 0;

  CreaseProfile() = default;
  /// Walks on the surface, from three places an edge and three in all at least, end at walls.
  CreaseProfile(
    const Atlas& atlas, const SurfaceWalk& surfaceWalk, int backbone, double edgeLength);

  bool isSteady() const { return this->unsteadiness <= Tuning::LargestUnsteadiness * this->bend; }
  /// How deep below a crease an edge lies that crosses it with its middle, over the edge's length;
  /// infinite for the rim of a sheet.
  double depth() const;
};

/// Gives up creases that are not steady for the triangles with an angle less than `poorAngle`, in
/// radians, that have a corner on them: where these are worth it that each edge on the crease comes
/// to lie at its depth. A triangle is worth what simplifyFeatures() may move the surface by for it,
/// all of them together so many times an edge; no edge more than that, or than shows. Creases that
/// users named stay. Returns how many there were.
STIPPLEFILTERSOPTIMIZATION_EXPORT int giveUpUnsteadyCreases(
  OptimizedMesh& mesh, double tolerance, double poorAngle = Tuning::PoorFeatureAngle);
}

#endif
