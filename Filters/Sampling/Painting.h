// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Painting on the surface (paper 3.3): a brush adds density to the importance, or erases it, and
// takes paint away; so does a bucket that fills a region.
#ifndef stipple_Painting_h
#define stipple_Painting_h

#include "AtlasSurface.h"
#include "ControlImage.h"

#include <vector>

namespace stipple
{
/// One dab of the brush, or a region that is filled.
struct BrushStroke
{
  Vec3 position = Vec3::Zero(); ///< moved to the nearest place on the surface
  double radius = 0.;           ///< >= 0, in the surface's unit of length; 0 fills the region
  double strength = 0.;         ///< >= -1: what is added at the brush's centre; below zero, minus
                                ///< the share that is erased there; zero takes away the paint of
                                ///< the strokes before
  bool operator==(const BrushStroke& o) const
  {
    return position == o.position && radius == o.radius && strength == o.strength;
  }
};

/// What all strokes together make of a pixel's importance v: factor v + offset. Both are empty on a
/// chart that no stroke has touched.
struct PaintLayer
{
  std::vector<float> factor;
  std::vector<float> offset;
};

/// The weight of a brush at a squared distance from its centre: (1 - d^2 / r^2)^2, zero from the
/// radius on.
inline double brushWeight(double squaredDistance, double radius)
{
  const double t = 1. - squaredDistance / (radius * radius);
  return t > 0. ? t * t : 0.;
}

/// The face nearest to a position, and the nearest place on it.
STIPPLEFILTERSSAMPLING_EXPORT int nearestFace(
  const TriangleSurface& surface, const Vec3& position, Vec3& place);

/// Adds one stroke to the layers, one a chart. The brush reaches what of the surface lies in its
/// ball and hangs together there with its centre: across seams and from chart to chart, but not
/// through thin air to the other side of a thin plate. Distances are straight. A stroke without a
/// radius reaches all that hangs together with its centre without crossing a wall, evenly. `walls`
/// has 1 for the halfedges that it does not cross, or is empty. The images say by faceIndex which
/// pixels a face owns.
STIPPLEFILTERSSAMPLING_EXPORT void paint(const AtlasSurface& surface,
  const std::vector<ControlImage>& images, const BrushStroke& stroke,
  const std::vector<char>& walls, std::vector<PaintLayer>& layers);
}

#endif
