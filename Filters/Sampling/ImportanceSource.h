// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What an importance reads at every pixel (paper 3.1): a curvature, an array, or a picture.
#ifndef stipple_ImportanceSource_h
#define stipple_ImportanceSource_h

#include "StippleFiltersSamplingModule.h"

#include <array>
#include <string>
#include <vector>

class vtkImageData;

namespace stipple
{
/// Where samples matter: vtkControlMap::ImportanceType.
enum class ImportanceKind
{
  Uniform,
  Mean,
  Gaussian,
  Minimum,
  Maximum,
  Total,
  L2,
  Image,
  Array
};

/// How a picture lies on the surface: over every chart's rectangle, or seen along an axis.
/// vtkControlMap::ProjectionType.
enum class PictureProjection
{
  Chart,
  XAxis,
  YAxis,
  ZAxis
};

/// Brightness of a picture at (x, y) in [0, 1]^2, linear between its pixels.
class STIPPLEFILTERSSAMPLING_EXPORT PictureBrightness
{
public:
  explicit PictureBrightness(vtkImageData* image);
  float operator()(double x, double y) const;

private:
  int Width;
  int Height;
  std::vector<float> Value;
};

struct STIPPLEFILTERSSAMPLING_EXPORT ImportanceSource
{
  ImportanceKind importance = ImportanceKind::Mean; ///< not Uniform
  const char* arrayName = nullptr;                  ///< for Array
  const PictureBrightness* picture = nullptr;       ///< for Image
  PictureProjection projection = PictureProjection::Chart;
  std::array<double, 6> bounds = { { 0. } }; ///< that a projected picture spans

  /// The quantity at every pixel of a map, negative values counting as none; returns the name of a
  /// missing array, or nothing.
  std::string fill(vtkImageData* map, float* magnitudes) const;

private:
  std::string fillFromPicture(vtkImageData* map, float* magnitudes) const;
};
}

#endif
