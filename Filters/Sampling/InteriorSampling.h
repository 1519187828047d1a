// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The samples inside one chart: 2D error diffusion of what its backbones leave (paper 3.2).
#ifndef stipple_InteriorSampling_h
#define stipple_InteriorSampling_h

#include "BandMask.h"
#include "ChordDistance.h"
#include "ControlImage.h"
#include "DiffusionCoefficients.h"
#include "NeighbourGrid.h"
#include "ReportingThread.h"
#include "SamplingDomain.h"

#include <vector>

namespace stipple
{
class STIPPLEFILTERSSAMPLING_EXPORT InteriorSampler
{
public:
  /// The graph's vertices are numbers of samples. All arguments are borrowed; scale times control
  /// is the wanted samples per unit of parameter area.
  InteriorSampler(const SamplingDomain& domain, int chart, const ControlImage& image,
    const ChartGraph& graph, const std::vector<Sample>& samples, double scale);

  /// The factor by which the image must be enlarged so that no pixel wants more than half a sample
  /// (but for spikes, see SamplingConstants::LargestForAll; or for any spikes), in quarters; it may
  /// be beyond the limits.
  static double upsampling(
    const ControlImage& image, double scale, const ControlMass& mass, bool spikes = true);
  static bool withinLimits(const ControlImage& image, double factor);

  /// Fills the raster: the control image, enlarged, less the band of 0.433 s on each side of every
  /// backbone (times its band's width): s sqrt(3)/2 is the height of a row of the hexagonal
  /// lattice, so that the band's mass is just what the samples on the backbone stand for.
  /// Once `stop` is true, it ends early, and so does sample(): of no use.
  void prepare(double factor, const BandMask& bands, const std::vector<BackboneDensity>& densities,
    const Stop& stop = {});
  double left() const { return this->Raster.left; }
  /// Gives the raster's memory back; sample() needs another prepare().
  void release();

  /// Exactly `count` places, in parameters: scaled error diffusion, less what lies too near to
  /// chords between samples on backbones: where a map is far denser than its pixels, their middles
  /// may. Then samples are added where the hole is largest, or removed where two are closest, in
  /// terms of the wanted spacing.
  std::vector<Vec2> sample(int count, DiffusionMethod method, const Stop& stop = {});

private:
  void maskOutside();
  void maskSegment(const Vec2& a, const Vec2& b);
  void sumLeft(const Stop& stop);
  /// What a pixel of the raster covers in a direction: pixels of the image, two at most.
  struct Overlap
  {
    int first;
    int second; ///< maybe the first
    float part; ///< of the pixel that is the first's
  };
  static std::vector<Overlap> overlaps(int n, int enlarged);
  /// What the pixels of the raster want, row by row; negative where it is for those beside them.
  class RowFiller;
  class WantedRows;
  Vec2 centre(int pixel) const;
  double control(const Vec2& uv) const;
  bool isTooNear(const ChordDistance& chords, const Vec2& uv) const;
  void add(const ChordDistance& chords, std::vector<Vec2>& places, int count);
  void addInGaps(std::vector<Vec2>& places, int count);
  void remove(std::vector<Vec2>& places, int count) const;
  NeighbourGrid gridOf(const std::vector<Vec2>& places) const;
  bool clearOfGraph(const Vec2& p) const;
  /// Of the principal axes of the polygon's corners, the one along which they lie.
  Vec2 longDirection() const;
  /// side x side nodes between the polygon's ends in a direction and across it.
  std::vector<Vec2> latticeIn(const Vec2& along, int side) const;

  const SamplingDomain& Domain;
  const int Chart;
  const ControlImage& Image;
  const ChartGraph& Graph;
  const std::vector<Sample>& Samples;
  const double Scale;
  InteriorRaster Raster;
  std::vector<Overlap> Columns;
  std::vector<Overlap> Rows;
};

/// The triangle of a chart that a parameter lies in, walking from a face of the chart, and its
/// barycentric coordinates there; for a parameter in no triangle, the nearest place of the last one
/// tried.
STIPPLEFILTERSSAMPLING_EXPORT void locate(
  const AtlasSurface& surface, int chart, const Vec2& uv, int startFace, int& face, Vec3& bary);
}

#endif
