// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Corners that two creases or boundaries leave at a small angle, and open later: farther out, the
// triangle between them has larger angles.
#ifndef stipple_AcuteCorners_h
#define stipple_AcuteCorners_h

#include "OptimizedMesh.h"
#include "StippleFiltersOptimizationModule.h"

#include <vector>

namespace stipple
{
class STIPPLEFILTERSOPTIMIZATION_EXPORT AcuteCorners
{
public:
  /// Of a mesh whose spacing has not grown anywhere yet; angle in radians, 0 for none.
  AcuteCorners(const OptimizedMesh& mesh, double angle);

  /// The regions about corners in which spacing must grow for their creases to be that far apart
  /// where the first points on them lie. Corners whose creases do not open so far within 3.4 edges
  /// stay as they are: larger triangles would not help them.
  SpacingRegions regions(const OptimizedMesh& mesh) const;

  /// Where a corner is sharper than asked for, regions() ask for what it lacks on top from now on:
  /// Lloyd's method does not put points just where spacing has them.
  void correct(const OptimizedMesh& mesh);

  /// By backbone: 1 for those that leave corners side by side, closer to each other than asked for
  /// or 25 degrees where the first points on them lie, and about which no spacing grows.
  std::vector<char> closedCreases(const OptimizedMesh& mesh) const;

private:
  struct Corner
  {
    Vertex vertex;
    double spacing; ///< about it
    double asked;   ///< angle
  };
  /// By how much spacing must grow about it.
  double growthAt(const OptimizedMesh& mesh, const Corner& corner) const;

  double Angle;
  std::vector<Corner> Corners;
};
}

#endif
