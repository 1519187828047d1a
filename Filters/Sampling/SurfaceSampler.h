// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Exactly N samples on the surface: backbones first, then the charts between them (paper 3.2).
#ifndef stipple_SurfaceSampler_h
#define stipple_SurfaceSampler_h

#include "ControlImage.h"
#include "DiffusionCoefficients.h"
#include "PlanarValidity.h"

namespace stipple
{
struct SurfaceSamples
{
  std::vector<Sample> samples; ///< nodes, constraints, backbone by backbone, chart by chart
  std::vector<double> density; ///< by sample, samples wanted per unit of surface area
  std::vector<ChartGraph> graphs;
  std::vector<std::vector<Vec2>> interior; ///< by chart, the parameters of the samples of kind
                                           ///< Interior
};

/// How charts are halftoned between backbones.
struct Halftoning
{
  DiffusionMethod method = DiffusionMethod::Ostromoukhov;
  bool upsampleSpikes = true; ///< see vtkErrorDiffusionSampler::SetUpsampleSpikes()
};

class STIPPLEFILTERSSAMPLING_EXPORT SurfaceSampler
{
public:
  /// Takes charts and feature graph, and finds the least that a triangulation of them needs;
  /// nothing if they are those that it has.
  Status setDomain(vtkPartitionedDataSetCollection* charts, vtkPolyData* lines);
  const SamplingDomain& domain() const { return this->Domain; }

  /// The nodes, the constraints, the fewest samples on backbones that make every chart's graph
  /// valid, and one inside each chart that only three samples bound.
  int minimumNumberOfSamples() const { return this->Minimum; }

  /// Exactly numberOfSamples samples in proportion to the control images, one a chart, that can be
  /// meshed: where charts of few samples have no triangulation together, some move inside the chart
  /// at fault. Where these cannot be spared, or there are fewer samples than the minimum, they are
  /// too few points, and the status has a number that can be had of these images, near the next.
  Status sample(const std::vector<ControlImage>& images, int numberOfSamples,
    const Progress& progress, SurfaceSamples& result, const Halftoning& halftoning = {});

private:
  Status sampleToMesh(const std::vector<ControlImage>& images, int numberOfSamples,
    const Progress& progress, const Halftoning& halftoning, SurfaceSamples& result);
  bool mayNotMesh(const SurfaceSamples& result) const;

  SamplingDomain Domain;
  ValidPlaces Least;
  int Minimum = 0;
};

/// The search for a number that works, when trying one is dear: what to try after one that is too
/// few (-1: none yet) and, if it is not negative, one that is enough; -1 if no more is to be
/// gained. It ends: what is tried lies beyond what was too few, up to the most, or between the two.
/// The last one that was enough is at most half more than what was too few.
STIPPLEFILTERSSAMPLING_EXPORT int nextToTry(int tooFew, int enough, int most);
}

#endif
