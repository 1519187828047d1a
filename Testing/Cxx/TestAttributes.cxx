// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What the input's points and cells carry survives a remesh: scalars, vectors and texture
// coordinates within the error of linear interpolation, labels as they are.
#include "Check.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkGeometryMapRenderer.h"
#include "vtkGeometryRemesher.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace
{
using test::check;

using Point = std::array<double, 3>;

double scalarAt(const Point& p)
{
  return std::sin(3. * p[0]) * std::cos(2. * p[1]);
}
/// Its second derivative along any line is at most 3^2 + 2^2 in absolute value.
constexpr double Bending = 13.;

Point vectorAt(const Point& p)
{
  return { { -p[1], p[0], 2. * p[2] + 1. } };
}

std::array<double, 2> textureAt(const Point& p)
{
  return { { 0.5 + 0.4 * p[0], 0.5 + 0.4 * p[2] } };
}

int labelAt(const Point& p)
{
  return p[2] > 0.2 ? 17 : -4;
}

/// Mean height of a cell's points, by which its label goes.
double heightOfCell(vtkPolyData* mesh, vtkIdType c)
{
  vtkIdType n = 0;
  const vtkIdType* ids = nullptr;
  mesh->GetCellPoints(c, n, ids);
  double z = 0;
  for (vtkIdType k = 0; k < n; ++k)
  {
    z += mesh->GetPoint(ids[k])[2] / static_cast<double>(n);
  }
  return z;
}

vtkSmartPointer<vtkPolyData> makeInput()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1.);
  sphere->SetThetaResolution(60);
  sphere->SetPhiResolution(40);
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  sphere->Update();
  auto input = vtkSmartPointer<vtkPolyData>::New();
  input->SetPoints(sphere->GetOutput()->GetPoints());
  input->SetPolys(sphere->GetOutput()->GetPolys());
  vtkNew<vtkDoubleArray> scalar;
  scalar->SetName("Temperature");
  vtkNew<vtkDoubleArray> vector;
  vector->SetName("Velocity");
  vector->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> texture;
  texture->SetName("Texture");
  texture->SetNumberOfComponents(2);
  vtkNew<vtkIntArray> label;
  label->SetName("Region");
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    Point p;
    input->GetPoint(i, p.data());
    scalar->InsertNextValue(scalarAt(p));
    vector->InsertNextTuple(vectorAt(p).data());
    texture->InsertNextTuple(textureAt(p).data());
    label->InsertNextValue(labelAt(p));
  }
  vtkNew<vtkIntArray> material;
  material->SetName("Material");
  vtkNew<vtkStringArray> word;
  word->SetName("Word");
  for (vtkIdType c = 0; c < input->GetNumberOfCells(); ++c)
  {
    const int value = labelAt({ { 0., 0., heightOfCell(input, c) } });
    material->InsertNextValue(value);
    word->InsertNextValue(value > 0 ? "above" : "below");
  }
  input->GetPointData()->SetScalars(scalar);
  input->GetPointData()->SetVectors(vector);
  input->GetPointData()->SetTCoords(texture);
  input->GetPointData()->AddArray(label);
  input->GetCellData()->AddArray(material);
  input->GetCellData()->AddArray(word);
  return input;
}

/// The longest edge of the input: what interpolation errs by goes with its square.
double longestEdge(vtkPolyData* mesh)
{
  double longest = 0;
  for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
  {
    vtkIdType n = 0;
    const vtkIdType* ids = nullptr;
    mesh->GetCellPoints(c, n, ids);
    for (vtkIdType k = 0; k < n; ++k)
    {
      Point a;
      Point b;
      mesh->GetPoint(ids[k], a.data());
      mesh->GetPoint(ids[(k + 1) % n], b.data());
      longest = std::max(longest, vtkMath::Distance2BetweenPoints(a.data(), b.data()));
    }
  }
  return std::sqrt(longest);
}

void checkPoints(const std::string& name, vtkPolyData* mesh, double edge)
{
  vtkPointData* data = mesh->GetPointData();
  vtkDataArray* scalar = data->GetArray("Temperature");
  vtkDataArray* vector = data->GetArray("Velocity");
  vtkDataArray* texture = data->GetArray("Texture");
  vtkDataArray* label = data->GetArray("Region");
  if (!scalar || !vector || !texture || !label)
  {
    check(false, name + ": point arrays arrive");
    return;
  }
  check(scalar->GetDataType() == VTK_DOUBLE && vector->GetDataType() == VTK_DOUBLE &&
      texture->GetDataType() == VTK_FLOAT && label->GetDataType() == VTK_INT,
    name + ": types are kept");
  check(data->GetScalars() == scalar && data->GetVectors() == vector,
    name + ": the active scalars and vectors are the input's");
  check(data->GetTCoords() == texture, name + ": so are the active texture coordinates");
  double scalarError = 0;
  double vectorError = 0;
  double textureError = 0;
  int blended = 0;
  int wrong = 0;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    Point p;
    mesh->GetPoint(i, p.data());
    scalarError = std::max(scalarError, std::abs(scalar->GetTuple1(i) - scalarAt(p)));
    for (int k = 0; k < 3; ++k)
    {
      vectorError = std::max(vectorError, std::abs(vector->GetComponent(i, k) - vectorAt(p)[k]));
    }
    for (int k = 0; k < 2; ++k)
    {
      textureError =
        std::max(textureError, std::abs(texture->GetComponent(i, k) - textureAt(p)[k]));
    }
    const int value = static_cast<int>(label->GetTuple1(i));
    blended += value != 17 && value != -4;
    wrong += std::abs(p[2] - 0.2) > edge && value != labelAt(p);
  }
  std::cout << name << ": errors of a scalar " << scalarError << ", a vector " << vectorError
            << ", texture coordinates " << textureError << "\n";
  // Points lie on flat input triangles: what is linear in space arrives as it is. Of the rest,
  // linear interpolation errs by half the bending times the square of the radius of a circle about
  // the triangle, which is at most the longest edge over the root of 3.
  check(scalarError > 0 && scalarError < Bending * edge * edge / 6., name + ": a scalar");
  check(vectorError < 1e-9, name + ": a vector");
  check(textureError < 1e-6, name + ": texture coordinates");
  check(blended == 0 && wrong == 0, name + ": a label of points");
}

void checkCells(const std::string& name, vtkPolyData* mesh, double edge)
{
  vtkDataArray* material = mesh->GetCellData()->GetArray("Material");
  auto* word = vtkStringArray::SafeDownCast(mesh->GetCellData()->GetAbstractArray("Word"));
  if (!material || !word)
  {
    check(false, name + ": cell arrays arrive");
    return;
  }
  check(material->GetDataType() == VTK_INT, name + ": the type of a label of cells");
  int wrong = 0;
  for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
  {
    const double z = heightOfCell(mesh, c);
    const int value = static_cast<int>(material->GetTuple1(c));
    wrong +=
      std::abs(z - 0.2) > edge ? value != labelAt({ { 0., 0., z } }) : value != 17 && value != -4;
    wrong += word->GetValue(c) != (value > 0 ? "above" : "below");
  }
  check(wrong == 0, name + ": labels and words of cells");
}
}

int TestAttributes(int, char*[])
{
  const vtkSmartPointer<vtkPolyData> input = makeInput();
  const double edge = longestEdge(input);
  for (const int charts : { 1, 6 })
  {
    for (const int pattern : { vtkGeometryRemesher::TRIANGLES, vtkGeometryRemesher::SEMIREGULAR })
    {
      vtkNew<vtkGeometryRemesher> remesher;
      remesher->SetInputData(input);
      remesher->SetNumberOfPoints(
        pattern == static_cast<int>(vtkGeometryRemesher::TRIANGLES) ? 1500 : 200);
      remesher->SetPattern(pattern);
      remesher->SetNumberOfCharts(charts);
      remesher->GetMapRenderer()->SetBackendToCPU();
      remesher->Update();
      const std::string name =
        std::to_string(charts) + " charts, pattern " + std::to_string(pattern);
      check(remesher->GetOutput()->GetNumberOfPoints() >= 1500, name + ": a mesh");
      checkPoints(name, remesher->GetOutput(), edge);
      checkCells(name, remesher->GetOutput(), edge);
    }
  }
  return test::exitStatus();
}
