// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Control maps from geometry maps (paper 3.1 and 3.3): the steps of an importance, each kept for as
// long as what it is made from stays.
#ifndef stipple_ControlMapBuilder_h
#define stipple_ControlMapBuilder_h

#include "ImportanceSource.h"
#include "Painting.h"
#include "Progress.h"
#include "SizingFunction.h"

#include "vtkFloatArray.h"
#include "vtkSmartPointer.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

class vtkImageData;
class vtkPartitionedDataSetCollection;
class vtkPolyData;
class vtkPiecewiseFunction;

namespace stipple
{
/// The parameters of vtkControlMap, in the order in which they act.
struct ControlMapOptions
{
  ImportanceKind importance = ImportanceKind::Uniform;
  std::string arrayName;         ///< for Array
  vtkImageData* image = nullptr; ///< for Image
  PictureProjection projection = PictureProjection::Chart;
  std::array<double, 2> bandPass = { { 0. } }; ///< fine and coarse, % of the diagonal; 0, 0: none
  vtkPiecewiseFunction* transfer = nullptr;    ///< null: none
  double gamma = 1.;                           ///< 0 or more
  double gradation = 0.;                       ///< % of the diagonal; 0: none
  double tolerance = 1e-7;                     ///< see SurfaceDiffusion::setTolerance()
  std::vector<BrushStroke> strokes;
  double minimumDensity = 0.02; ///< part of the largest, 0 to 1
  std::string sizeArray;        ///< lengths of edges, in place of an importance
  double curvaturePoints = 0;   ///< the same from curvature, edges a full turn; 0: none
  SizingOptions sizing;
  bool growFromFeatures = true; ///< not for CurvaturePoints alone
};

class ControlMapBuilder
{
public:
  ControlMapBuilder();
  ~ControlMapBuilder();

  /// The control of every map, in `control`, or what is wrong with the input in one sentence; a
  /// result that is not what was asked for is explained in `warning`. `charts` may be null where
  /// nothing works on the surface.
  Status build(vtkPartitionedDataSetCollection* maps, vtkPartitionedDataSetCollection* charts,
    vtkPolyData* featureGraph, const ControlMapOptions& options, const Progress& progress,
    std::vector<vtkSmartPointer<vtkFloatArray>>& control, std::string& warning);

  /// Of the last control; no samples if nothing says in what unit it is.
  const Sizes& sizes() const;

private:
  struct Internals;
  std::unique_ptr<Internals> Data;
};
}

#endif
