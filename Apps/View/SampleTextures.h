// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The live preview: each chart's halftone as a texture on the surface (paper 3.3, Figure 5).
//
// A pixel of such a texture is the number of the sample that is nearest to it, if one is near; a
// second texture holds where every sample lies on the surface and how large its dot is. What is
// dark is decided for each pixel of the screen: the dots are as sharp as the screen, round on the
// surface however the map is stretched, and whole where two charts meet.
#ifndef stipple_SampleTextures_h
#define stipple_SampleTextures_h

#include "DotPainter.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkActor;
class vtkImageData;
class vtkPartitionedDataSetCollection;

namespace stipple
{
class SampleTextures
{
public:
  SampleTextures();
  ~SampleTextures();
  SampleTextures(const SampleTextures&) = delete;
  SampleTextures& operator=(const SampleTextures&) = delete;

  /// The atlas whose charts are shown, an actor each, without a sample so far.
  void setCharts(vtkPartitionedDataSetCollection* charts);
  const std::vector<vtkSmartPointer<vtkActor>>& actors() const { return this->Actors; }

  /// Those of the charts that are shown; others are not looked at.
  void setImages(const DotImages& images);

private:
  std::vector<vtkSmartPointer<vtkActor>> Actors;
  std::vector<vtkSmartPointer<vtkImageData>> Numbers; ///< by chart
  vtkNew<vtkImageData> Places;
};
}

#endif
