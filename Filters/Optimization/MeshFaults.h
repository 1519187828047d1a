// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What is wrong with a mesh, or poor, because its edges are too long for the surface there.
#ifndef stipple_MeshFaults_h
#define stipple_MeshFaults_h

#include "SelfIntersections.h"
#include "StippleFiltersOptimizationModule.h"

#include <vector>

namespace stipple
{
/// How many triangles pass through others, and what others lack of an angle. What is wrong goes
/// before what is ugly: less is better.
struct FaultSum
{
  int overlaps = 0;
  double lack = 0; ///< of angles, squared: one that lacks much is worse than some that lack little

  /// By Tuning::LeastGainOfRefinement of what counts most.
  bool isMuchLessThan(const FaultSum& o) const;
  friend bool operator<(const FaultSum& a, const FaultSum& b)
  {
    return a.overlaps != b.overlaps ? a.overlaps < b.overlaps : a.lack < b.lack;
  }
};

/// Triangles that pass through others where the surface does not (overlapsOf()): sheets are closer
/// together than edges are long. And triangles with an angle of less than Tuning::NarrowAngle that
/// is not between two creases, where it would be the surface's own: the surface is bent more, or
/// narrower, than they can follow.
class STIPPLEFILTERSOPTIMIZATION_EXPORT MeshFaults
{
public:
  struct Fault
  {
    Face face;
    Vec3 position; ///< in its middle
    FaultSum share;
  };

  MeshFaults(const OptimizedMesh& mesh, KnownOverlaps& known);

  /// Ascending by face, each once.
  const std::vector<Fault>& all() const { return this->Faults; }
  FaultSum sum() const;
  /// Of those whose middles are less than a distance from a place.
  FaultSum sumNear(const Vec3& place, double distance) const;

private:
  std::vector<Fault> Faults;
};
}

#endif
