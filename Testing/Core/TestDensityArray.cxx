// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "DensityArray.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <limits>

using stipple::checkDensityArray;
using stipple::checkSizeArray;

namespace
{
vtkSmartPointer<vtkDoubleArray> numbers(const char* name, double second)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->InsertNextValue(1);
  array->InsertNextValue(second);
  return array;
}
}

TEST(DensityArray, FiniteNumbersAreGood)
{
  vtkNew<vtkPolyData> input;
  input->GetPointData()->AddArray(numbers("weight", -2));
  EXPECT_TRUE(checkDensityArray(input, "weight").ok());
  EXPECT_TRUE(checkDensityArray(input, "MeanCurvature").ok()) << "a map's name, not the input's";
  EXPECT_TRUE(checkDensityArray(input, nullptr).ok());
}

TEST(DensityArray, WhatIsNotFiniteIsNamed)
{
  vtkNew<vtkPolyData> input;
  input->GetPointData()->AddArray(numbers("weight", std::numeric_limits<double>::quiet_NaN()));
  input->GetCellData()->AddArray(numbers("size", -std::numeric_limits<double>::infinity()));
  EXPECT_EQ(checkDensityArray(input, "weight").message(),
    "The array weight of the input is NaN at point 1: it must be finite.");
  EXPECT_EQ(checkDensityArray(input, "size").message(),
    "The array size of the input is infinite at cell 1: it must be finite.");
}

TEST(DensityArray, LengthsAreSingleNumbersAboveZero)
{
  vtkNew<vtkPolyData> input;
  input->GetPointData()->AddArray(numbers("good", 1e-300));
  input->GetPointData()->AddArray(numbers("none", 0));
  input->GetCellData()->AddArray(numbers("less", -1));
  auto pairs = vtkSmartPointer<vtkDoubleArray>::New();
  pairs->SetName("pairs");
  pairs->SetNumberOfComponents(2);
  pairs->InsertNextTuple2(1, 1);
  input->GetPointData()->AddArray(pairs);
  EXPECT_TRUE(checkSizeArray(input, "good").ok());
  EXPECT_TRUE(checkSizeArray(input, nullptr).ok());
  EXPECT_TRUE(checkDensityArray(input, "none").ok());
  EXPECT_EQ(checkSizeArray(input, "none").message(),
    "The array none of the input is not above 0 at point 1: no edge can have that length.");
  EXPECT_EQ(checkSizeArray(input, "less").message(),
    "The array less of the input is not above 0 at cell 1: no edge can have that length.");
  EXPECT_NE(checkSizeArray(input, "pairs").message().find("2 components"), std::string::npos);
}

TEST(DensityArray, StipplesOwnNamesAreRefused)
{
  for (const char* name : { "MeanCurvature", "UV", "Control", "SourceCellId" })
  {
    vtkNew<vtkPolyData> input;
    input->GetPointData()->AddArray(numbers(name, 2));
    EXPECT_NE(checkDensityArray(input, name).message().find("rename it"), std::string::npos)
      << name;
  }
}
