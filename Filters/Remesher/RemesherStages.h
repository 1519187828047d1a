// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The pipeline's stages, joined, as vtkGeometryRemesher runs them.
#ifndef stipple_RemesherStages_h
#define stipple_RemesherStages_h

#include "StippleFiltersRemesherModule.h"

#include "vtkCDTRemesh.h"
#include "vtkConformalAtlas.h"
#include "vtkControlMap.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkErrorDiffusionSampler.h"
#include "vtkGeometryMapRenderer.h"
#include "vtkNew.h"
#include "vtkQuadRemesh.h"
#include "vtkRemeshOptimizer.h"
#include "vtkSemiRegularSubdivision.h"
#include "vtkSmartPointer.h"

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
  std::array<double, 2> progressOf(int algorithm) const;

  /// The algorithm whose output is the mesh of a pattern.
  vtkAlgorithm* last(int pattern) const;
  /// Whether triangles' edges are to be EdgeLength long everywhere.
  bool hasOneEdgeLength() const;
  /// The maps that control map and sampler read, by the control map's importance.
  std::vector<std::string> neededMaps() const;
  /// Adds them to what the caller selected, and takes back what was added for another importance.
  void selectMaps();

  /// What the algorithms behind the atlas have made, with what they made it from.
  struct Made
  {
    vtkMTimeType atlas = 0;
    std::vector<vtkSmartPointer<vtkDataObject>> outputs; ///< of all ports, in order
    int overlaps = 0;
    int simplifiedFeatures = 0;
    int simplifiedFeaturesOfQuads = 0;
    int leastNumberOfSamples = 0;
    vtkIdType samplesOfMaps = 0;
    int samplesOfControl = 0;
    int samples = 0;
    bool raises = false;
    bool grows = false;
    double toleranceScale = 1.;
    vtkSmartPointer<vtkDoubleArray> sizePlaces;
  };
  /// Keeps that, while others are made.
  Made made();
  /// Puts it back, outputs and parameters, in no time; false if the atlas is another one by now.
  bool putBack(const Made& made);

  vtkNew<vtkConformalAtlas> Atlas;
  vtkNew<vtkGeometryMapRenderer> MapRenderer;
  vtkNew<vtkControlMap> ControlMap;
  vtkNew<vtkErrorDiffusionSampler> Sampler;
  vtkNew<vtkCDTRemesh> Mesher;
  vtkNew<vtkRemeshOptimizer> Optimizer;
  vtkNew<vtkQuadRemesh> QuadMesher;
  vtkNew<vtkSemiRegularSubdivision> Subdivider;
  std::array<vtkAlgorithm*, NumberOfAlgorithms> InOrder;
  int Pattern = 0;          ///< of the mesh: vtkGeometryRemesher::TRIANGLES, ...
  int NumberOfOverlaps = 0; ///< of the mesh, once they are counted

private:
  /// Calls visit(data object) for all ports of the algorithms behind the atlas.
  template <typename Visit>
  void forEachOutput(const Visit& visit)
  {
    for (std::size_t a = 1; a < this->InOrder.size(); ++a)
    {
      for (int port = 0; port < this->InOrder[a]->GetNumberOfOutputPorts(); ++port)
      {
        visit(this->InOrder[a]->GetOutputDataObject(port));
      }
    }
  }
  vtkMTimeType timeOfAtlas();

  std::vector<std::string> EnabledMaps; ///< those that this added to the selection
};
}

#endif
