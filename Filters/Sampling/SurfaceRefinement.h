// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The surface with its long edges split, and where the pixels of its charts' images lie on it.
#ifndef stipple_SurfaceRefinement_h
#define stipple_SurfaceRefinement_h

#include "AtlasSurface.h"
#include "ControlImage.h"

#include <functional>
#include <vector>

namespace stipple
{
/// Triangles that tile the faces of a surface. Points are shared as on the surface, also across
/// seams.
struct STIPPLEFILTERSSAMPLING_EXPORT RefinedSurface
{
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  std::vector<std::array<Vec2, 3>> uv; ///< per corner, in the chart of the face
  std::vector<int> face;               ///< of the surface; ascending
  int numberOfTriangles() const { return static_cast<int>(this->triangles.size()); }
};

/// Halves edges until each is at most `longest` in space, or shorter than two pixels in every chart
/// that has it.
STIPPLEFILTERSSAMPLING_EXPORT RefinedSurface refine(
  const AtlasSurface& surface, const std::vector<ControlImage>& images, double longest);
/// The same with edges between two places that are too long by a rule of the caller's, which is
/// asked on several threads.
STIPPLEFILTERSSAMPLING_EXPORT RefinedSurface refine(const AtlasSurface& surface,
  const std::vector<ControlImage>& images,
  const std::function<bool(const Vec3&, const Vec3&)>& isTooLong);

/// The triangle that a pixel's centre lies in, and its barycentric coordinates there.
struct PixelPlace
{
  int triangle = -1;
  float bary[3] = { 1.f, 0.f, 0.f };
};

/// The places of all pixels of a chart's image, by its faceIndex.
STIPPLEFILTERSSAMPLING_EXPORT std::vector<PixelPlace> placePixels(
  const AtlasSurface& surface, const RefinedSurface& refined, int chart, const ControlImage& image);
}

#endif
