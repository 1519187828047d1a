// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The models that are timed, and a number of threads for a while.
#ifndef stipple_BenchmarkModels_h
#define stipple_BenchmarkModels_h

#include "ModelFile.h"

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
  return testing::readOff(std::string(folder ? folder : STIPPLE_MODELS) + "/" + name + ".off");
}

inline const char* const NoModel = "model not found: run sh Testing/Data/fetch-models.sh";

/// Runs f with a number of threads.
template <typename F>
void withThreads(int threads, F f)
{
  vtkSMPTools::LocalScope(vtkSMPTools::Config(threads), f);
}
}

#endif
