// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The models that tests of the programs read.
#ifndef stipple_TestModels_h
#define stipple_TestModels_h

#include "MeshFile.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

/// NAME.off of the folder MODELS, or of the current one; a failure of the test if it is not there.
inline vtkSmartPointer<vtkPolyData> readModel(const std::string& name)
{
  const char* folder = std::getenv("MODELS");
  vtkSmartPointer<vtkPolyData> mesh;
  const stipple::Status status =
    stipple::readMesh(std::string(folder ? folder : ".") + "/" + name + ".off", mesh);
  EXPECT_TRUE(status.ok()) << status.message();
  return mesh;
}

#endif
