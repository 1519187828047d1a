// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What an importance reads at every pixel (paper 3.1): a curvature, an array, or a picture.
#ifndef stipple_ImportanceSource_h
#define stipple_ImportanceSource_h

#include <array>
#include <string>
#include <vector>

class vtkImageData;

namespace stipple
{
/// Brightness of a picture at (x, y) in [0, 1]^2, linear between its pixels.
class PictureBrightness
{
public:
  explicit PictureBrightness(vtkImageData* image);
  float operator()(double x, double y) const;

private:
  int Width;
  int Height;
  std::vector<float> Value;
};

struct ImportanceSource
{
  int importance;                             ///< vtkControlMap::ImportanceType, not UNIFORM
  const char* arrayName = nullptr;            ///< for ARRAY
  const PictureBrightness* picture = nullptr; ///< for IMAGE
  int projection = 0;                         ///< vtkControlMap::ProjectionType
  std::array<double, 6> bounds = { { 0. } };  ///< that a projected picture spans

  /// The quantity at every pixel of a map, negative values counting as none; returns the name of a
  /// missing array, or nothing.
  std::string fill(vtkImageData* map, float* magnitudes) const;

private:
  std::string fillFromPicture(vtkImageData* map, float* magnitudes) const;
};
}

#endif
