// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What lies in the bands of a chart's backbones: pixels that leave their samples to the lines.
#ifndef stipple_BandMask_h
#define stipple_BandMask_h

#include "BackboneSampling.h"
#include "ControlImage.h"
#include "ReportingThread.h"
#include "SamplingDomain.h"

#include <cstddef>
#include <vector>

namespace stipple
{
/// A chart's wanted samples, pixel by pixel: those of the control image, enlarged, less what lies
/// in the bands of backbones and outside the boundary's polygon.
struct InteriorRaster
{
  /// A pixel that bands leave whole, and the mark of one that may hold no sample: what it wants is
  /// for those beside it.
  static constexpr unsigned char Whole = 127;
  static constexpr unsigned char Blocked = 128;

  int width = 0;
  int height = 0;
  std::vector<int> column;         ///< of the control image, by column of the raster
  std::vector<int> row;            ///< and by row
  std::vector<unsigned char> part; ///< that bands leave, in 127ths; and perhaps Blocked
  float toWanted = 0;              ///< control to samples a pixel
  double left = 0;                 ///< sum of what is wanted

  bool mayHoldSample(std::size_t pixel) const
  {
    return this->part[pixel] > 0 && this->part[pixel] < Blocked;
  }
};

/// How far a chart's pixels are from its backbones and constraints, on the surface, where bands may
/// be. A pixel has the line that is nearest to its middle from one beside it, as in
/// P.-E. Danielsson, "Euclidean distance mapping", 1980.
class STIPPLEFILTERSSAMPLING_EXPORT BandMask
{
public:
  /// For samples of `scale` times the image's control, for half as many, or for more. `domain` and
  /// what the image shows are used as long as this is. Once `stop` is true, this ends early and
  /// leaves nothing of use, and so does close().
  void build(const SamplingDomain& domain, int chart, const ControlImage& image, double scale,
    const Stop& stop = {});

  /// Takes from the pixels of a raster what lies in the bands of backbones with these densities,
  /// for samples of scale times the control, and blocks those whose middle does; those that want
  /// nothing are left as they are.
  void close(const std::vector<BackboneDensity>& densities, double scale, InteriorRaster& raster,
    const Stop& stop = {}) const;
  /// The part of the control that it would close, of an image without a raster.
  double share(const std::vector<BackboneDensity>& densities, double scale) const;

private:
  /// A straight piece of a backbone, or a constraint.
  struct Line
  {
    Vec2 a;
    Vec2 e;           ///< from a to the other end
    double limit;     ///< of squared distance x density, in a band of width 1
    int backbone;     ///< -1 for a constraint
    double arcLength; ///< at a
    double rise;      ///< of the arc length, to the other end
  };
  /// What is near to a line where the chart's map has a first fundamental form.
  struct Surroundings;
  FirstFundamentalForm form(int pixel) const;
  /// From the middle of a pixel to a corner, over the root of the limit of the pixel's line.
  double toCorner(int pixel) const;
  void addLines(const SamplingDomain& domain, int chart);
  void offer(int pixel, int line);
  void spread(double scale, const Stop& stop);
  /// A scale of the control and what is wanted along backbones.
  struct Control;
  Control controlOf(const std::vector<BackboneDensity>& densities, double scale) const;
  /// The band of a backbone where a pixel is.
  struct Band;
  /// Whether a band touches a pixel, and which.
  bool isInBand(const Control& control, int pixel, Band& band) const;
  /// The part of a box around a place in a pixel that is within reach of the pixel's line: as if
  /// that were straight.
  double partWithin(int pixel, double reach, const Vec2& middle, const Vec2& half) const;
  /// The same in a box of the raster, that of a pixel, as far as a band reaches.
  void closePixel(int pixel, const Band& band, const PixelBox& box, InteriorRaster& raster) const;

  ControlImage Image;
  const FirstFundamentalForm* Metric = nullptr; ///< of the chart's first triangle
  int NumberOfFaces = 0;

  std::vector<Line> Lines;
  std::vector<int> Nearest; ///< line, by pixel; -1 far from all
  std::vector<float> Apart; ///< squared distance over the line's limit, of the pixel's middle
  std::vector<int> Queue;   ///< of pixels that were offered a nearer line
  std::vector<float> Low;   ///< as Apart, less than it is anywhere in the pixel; far from all,
                            ///< infinite
  std::vector<float> High;  ///< as Apart, more than it is anywhere in the pixel
};
}

#endif
