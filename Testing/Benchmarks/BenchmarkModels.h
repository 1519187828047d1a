// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The models that are timed, the size of maps, and a number of threads for a while.
#ifndef stipple_BenchmarkModels_h
#define stipple_BenchmarkModels_h

#include "ModelFile.h"

#include "vtkImageData.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <cstdlib>
#include <string>

namespace benchmarks
{
/// NAME.off of the folder MODELS, or of the build's models; null if it is not there.
inline vtkSmartPointer<vtkPolyData> readModel(const std::string& name)
{
  const char* folder = std::getenv("MODELS");
  return test::readOff(std::string(folder ? folder : STIPPLE_MODELS) + "/" + name + ".off");
}

inline const char* const NoModel = "model not found: run sh Testing/Data/fetch-models.sh";

inline double pixelsOf(vtkPartitionedDataSetCollection* images)
{
  double pixels = 0;
  for (unsigned int c = 0; c < images->GetNumberOfPartitionedDataSets(); ++c)
  {
    pixels += static_cast<double>(
      vtkImageData::SafeDownCast(images->GetPartitionAsDataObject(c, 0))->GetNumberOfPoints());
  }
  return pixels;
}

/// Runs f with a number of threads.
template <typename F>
void withThreads(int threads, F f)
{
  vtkSMPTools::LocalScope(vtkSMPTools::Config(threads), f);
}
}

#endif
