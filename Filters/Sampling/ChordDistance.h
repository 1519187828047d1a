// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// How far places of a chart are from the chords between the samples on its backbones: edges that
// the mesh will have.
#ifndef stipple_ChordDistance_h
#define stipple_ChordDistance_h

#include "SamplingDomain.h"
#include "StippleFiltersSamplingModule.h"

#include "vtkNew.h"

#include <vector>

class vtkStaticPointLocator;

namespace stipple
{
class STIPPLEFILTERSSAMPLING_EXPORT ChordDistance
{
public:
  /// Of a chart's graph, whose vertices are numbers of these samples.
  ChordDistance(
    const AtlasSurface& surface, const ChartGraph& graph, const std::vector<Sample>& samples);
  ~ChordDistance();
  ChordDistance(const ChordDistance&) = delete;
  void operator=(const ChordDistance&) = delete;

  /// The squared distance in space from a place to the nearest of the chords that end at the four
  /// samples nearest to it; infinite if there are none.
  double squared(const Vec3& place) const;

private:
  std::vector<Vec3> Ends;                   // places of the graph's vertices
  std::vector<std::vector<int>> Neighbours; // along chords
  vtkNew<vtkStaticPointLocator> Locator;
};
}

#endif
