// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Places about which vertices shall lie farther apart, or closer together, than the density has it.
#ifndef stipple_SpacingRegions_h
#define stipple_SpacingRegions_h

#include "StippleFiltersOptimizationModule.h"
#include "SurfaceWalk.h"

#include <unordered_map>
#include <vector>

namespace stipple
{
/// About its centre, vertices shall lie `growth` times as far apart as the spacing that the density
/// asks for there, which is more or less; farther away, less and less so.
struct SpacingRegion
{
  Vec3 centre = Vec3::Zero();
  double spacing = 0;
  double growth = 1; ///< > 0

  /// By how much spacing grows at a distance from the centre; 1 from reach() on.
  double growthAt(double distance) const;
  double reach() const;
};

class STIPPLEFILTERSOPTIMIZATION_EXPORT SpacingRegions
{
public:
  /// Adds a region, whose centre lies on a face: what is near it in space but not on the surface
  /// stays out.
  void add(const TriangleSurface& surface, Face face, const SpacingRegion& region);

  bool empty() const { return this->Regions.empty(); }
  std::size_t size() const { return this->Regions.size(); }
  /// By how much spacing grows at a place, a position on a face. Where regions overlap, the one
  /// where it grows most counts, and the one where it shrinks most.
  double growthAt(Face face, const Vec3& position) const;

private:
  std::vector<SpacingRegion> Regions;
  std::unordered_map<Face, std::vector<int>> OnFace; // regions that reach a face
};
}

#endif
