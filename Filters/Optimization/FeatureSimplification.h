// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Features finer than the mesh: where corners and creases are closer together than triangles are
// large, these cannot be good. What is closer than a tolerance becomes one.
#ifndef stipple_FeatureSimplification_h
#define stipple_FeatureSimplification_h

#include "OptimizedMesh.h"
#include "StippleFiltersOptimizationModule.h"
#include "Tuning.h"

namespace stipple
{
/// Opens triangles between features that are closer together than the mesh is fine. The shortest
/// edge of a poor triangle is collapsed: what is on it goes to its other end, where as many creases
/// meet or more; or, where the third corner is near to the longest edge and that is a crease, the
/// crease is led over that corner; or the longest edge is swapped. What is as good as flat even
/// then (Tuning::NoAngle) is opened by a vertex from where it is needed least. Only where the worst
/// triangle about it becomes better, and the surface moves by at most `tolerance` times the spacing
/// for a triangle without an angle, in proportion less for a better one. Constraints and lines that
/// users named and the topology stay, borders of regions are straightened only, no triangle is
/// turned over, none folded onto its neighbour, and no more than before pass through each other of
/// those without a free corner. Vertices that this frees go where triangles are largest. Triangles
/// are looked at that have a corner on a feature and an angle less than `poorAngle`, in radians.
STIPPLEFILTERSOPTIMIZATION_EXPORT Status simplifyFeatures(
  OptimizedMesh& mesh, double tolerance, double poorAngle = Tuning::PoorFeatureAngle);
}

#endif
