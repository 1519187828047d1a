// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// A sound mesh of so many points: stages run, their mesh checked and, where it asks for it, made
// again.
#ifndef stipple_RemesherRun_h
#define stipple_RemesherRun_h

#include "Atlas.h"
#include "CoarsePlaces.h"
#include "Progress.h"
#include "RemesherStages.h"
#include "SelectedPart.h"
#include "StageRunner.h"
#include "StippleFiltersRemesherModule.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkWeakPointer.h"

#include <functional>
#include <string>

namespace stipple
{
class STIPPLEFILTERSREMESHER_EXPORT RemesherRun
{
public:
  explicit RemesherRun(RunCallbacks callbacks);

  RemesherStages& stages() { return this->Stages; }
  StageRunner& runner() { return this->Runner; }
  const SelectedPart& part() const { return this->Part; }

  /// Before the first mesh of an execution.
  void begin(int pattern);
  /// Hands the input, or the part of it that a cell array selects, to the atlas if it is not the
  /// one of before. `selection`: its name, or empty. Fails if an array cannot be used.
  Status takeInput(vtkPolyData* input, const std::string& selection);

  /// Makes a mesh of `points` points, besides those that are given; 0: of as many as lengths ask
  /// for, or as the surface has, or as it needs. An input without area makes an empty one.
  Status remesh(int points);
  /// Makes one of exactly so many, or of as few as there can be, whatever lengths ask for: a try
  /// of a search, half of what is left to do.
  Status tryNumber(int points);
  /// The one that is tried, 0 for none; from end() on there is none.
  int numberTried() const { return this->IsTried ? this->Points : 0; }
  void end() { this->IsTried = false; }

  /// Features that are simplified move no farther than this length on a surface of this area.
  void boundFeatures(double farthest, double area);

  /// What the last stage has made.
  vtkPolyData* mesh();
  /// Its points without those that are given.
  int numberOfPoints();
  /// Vertices that are not among those asked for: the ends of backbones that run from fixed point
  /// to fixed point. On the border of a part these are its edges; where cells of it touch in a
  /// point only, the surface has that point more than once.
  int numberOfGivenPoints();
  /// After a failure by StatusCode::TooFewPoints: the next number that can be had, or 0 if a mesh
  /// was made that is not sound. Else the least by count.
  int leastNumberOfPoints();

private:
  Status refine();
  Status makeSound();
  Status runStages(bool mayGrow, double toleranceScale);
  Status takeSamples();
  Status partSheets();
  Status subdivide();
  Status run(int algorithm);

  Status withAtlas(const std::function<Status(const Atlas&, const Progress&)>& work);
  Status check(vtkAlgorithm* algorithm);
  Status findPlaces(vtkPolyData* mesh, double share, vtkDoubleArray* overlapping,
    vtkDoubleArray* poor, CoarsePlaceCount& count);
  Status measureVisibleDistance(double& distance);

  double finestShare();
  double largestToleranceScale();
  bool sizesGrow();

  RemesherStages Stages;
  StageRunner Runner;

  vtkWeakPointer<vtkPolyData> Input;
  vtkMTimeType InputTime = 0;
  std::string Selection; ///< the array's name
  SelectedPart Part;

  int Points = 0;                     ///< asked for, or tried
  bool IsTried = false;               ///< by a search
  double FarthestFeature = 0;         ///< that features may move, a length; 0: as they would
  double Area = 0;                    ///< of the surface, if there is such a length
  vtkNew<vtkDoubleArray> Places;      ///< at which edges are to be shorter, for the control map
  vtkNew<vtkDoubleArray> Overlapping; ///< where the mesh before passes through itself: to be parted
  bool IsUnsound = false; ///< a mesh was made, and not sound: what would be is not known
};
}

#endif
