// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The pipeline's stages, joined, as vtkGeometryRemesher runs them.
#ifndef stipple_RemesherStages_h
#define stipple_RemesherStages_h

#include "StippleFiltersRemesherModule.h"

#include "vtkCDTRemesh.h"
#include "vtkConformalAtlas.h"
#include "vtkControlMap.h"
#include "vtkErrorDiffusionSampler.h"
#include "vtkGeometryMapRenderer.h"
#include "vtkNew.h"
#include "vtkQuadRemesh.h"
#include "vtkRemeshOptimizer.h"
#include "vtkSemiRegularSubdivision.h"

#include <array>
#include <string>
#include <vector>

namespace stipple
{
class STIPPLEFILTERSREMESHER_EXPORT RemesherStages
{
public:
  static constexpr int NumberOfStages = 6; ///< vtkGeometryRemesher::ATLAS to OPTIMISATION
  // Behind the stages come the algorithms that other patterns put in their places.
  static constexpr int QuadMeshing = 6;
  static constexpr int Subdivision = 7;
  static constexpr int NumberOfAlgorithms = 8;

  RemesherStages();

  /// The stage that an algorithm belongs to.
  static int stageOf(int algorithm);
  static const char* nameOf(int algorithm);
  /// Begin and end of an algorithm's progress in the whole: about the shares of time that stages
  /// take.
  static std::array<double, 2> progressOf(int algorithm, bool subdivides);

  /// The algorithm whose output is the mesh of a pattern (vtkGeometryRemesher::TRIANGLES, ...).
  vtkAlgorithm* last(int pattern) const;
  /// The maps that control map and sampler read, by the control map's importance.
  std::vector<std::string> neededMaps() const;
  /// Adds them to what the caller selected, and takes back what was added for another importance.
  void selectMaps();

  vtkNew<vtkConformalAtlas> Atlas;
  vtkNew<vtkGeometryMapRenderer> MapRenderer;
  vtkNew<vtkControlMap> ControlMap;
  vtkNew<vtkErrorDiffusionSampler> Sampler;
  vtkNew<vtkCDTRemesh> Mesher;
  vtkNew<vtkRemeshOptimizer> Optimizer;
  vtkNew<vtkQuadRemesh> QuadMesher;
  vtkNew<vtkSemiRegularSubdivision> Subdivider;
  std::array<vtkAlgorithm*, NumberOfAlgorithms> InOrder;

private:
  std::vector<std::string> EnabledMaps; ///< those that this added to the selection
};
}

#endif
