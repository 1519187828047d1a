// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SessionParameters.h"

#include "MeshFile.h"
#include "Messages.h"
#include "Session.h"

#include "vtkCellData.h"
#include "vtkConformalAtlas.h"
#include "vtkControlMap.h"
#include "vtkDoubleArray.h"
#include "vtkGeometryRemesher.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkImageReader2.h"
#include "vtkImageReader2Factory.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkXMLImageDataReader.h"

#include <algorithm>
#include <fstream>

namespace stipple
{
namespace
{
bool same(vtkPiecewiseFunction* function, const std::vector<std::pair<double, double>>& points)
{
  if (!function || function->GetSize() != static_cast<int>(points.size()))
  {
    return !function && points.empty();
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    double node[4];
    function->GetNodeValue(static_cast<int>(i), node);
    if (node[0] != points[i].first || node[1] != points[i].second)
    {
      return false;
    }
  }
  return true;
}

bool same(vtkPoints* points, const std::vector<Vec3>& positions)
{
  if (!points || points->GetNumberOfPoints() != static_cast<vtkIdType>(positions.size()))
  {
    return !points && positions.empty();
  }
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    if (Vec3(points->GetPoint(static_cast<vtkIdType>(i))) != positions[i])
    {
      return false;
    }
  }
  return true;
}

bool same(vtkIdTypeArray* ids, const std::vector<std::array<long long, 2>>& edges)
{
  if (!ids || ids->GetNumberOfTuples() != static_cast<vtkIdType>(edges.size()))
  {
    return !ids && edges.empty();
  }
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    const auto row = static_cast<vtkIdType>(i);
    if (ids->GetTypedComponent(row, 0) != edges[i][0] ||
      ids->GetTypedComponent(row, 1) != edges[i][1])
    {
      return false;
    }
  }
  return true;
}

bool same(vtkDoubleArray* array, const std::vector<std::array<double, 5>>& strokes)
{
  const vtkIdType count = array ? array->GetNumberOfTuples() : 0;
  if (count != static_cast<vtkIdType>(strokes.size()))
  {
    return false;
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    for (int k = 0; k < 5; ++k)
    {
      if (array->GetTypedComponent(i, k) != strokes[i][k])
      {
        return false;
      }
    }
  }
  return true;
}

void applyStrokes(const std::vector<std::array<double, 5>>& strokes, vtkControlMap* control)
{
  if (same(control->GetStrokes(), strokes))
  {
    return;
  }
  vtkNew<vtkDoubleArray> array;
  array->SetNumberOfComponents(5);
  for (const auto& stroke : strokes)
  {
    array->InsertNextTypedTuple(stroke.data());
  }
  control->SetStrokes(array);
}

void applyConstraints(const std::vector<Vec3>& positions, vtkGeometryRemesher* remesher)
{
  if (same(remesher->GetConstraints(), positions))
  {
    return;
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vec3& p : positions)
  {
    points->InsertNextPoint(p.data());
  }
  remesher->SetConstraints(positions.empty() ? nullptr : points.Get());
}

void applyFeatureEdges(
  const std::vector<std::array<long long, 2>>& edges, vtkGeometryRemesher* remesher)
{
  if (same(remesher->GetFeatureEdges(), edges))
  {
    return;
  }
  vtkNew<vtkIdTypeArray> ids;
  ids->SetNumberOfComponents(2);
  for (const auto& edge : edges)
  {
    const vtkIdType pair[2] = { static_cast<vtkIdType>(edge[0]), static_cast<vtkIdType>(edge[1]) };
    ids->InsertNextTypedTuple(pair);
  }
  remesher->SetFeatureEdges(edges.empty() ? nullptr : ids.Get());
}

Status checkArray(const std::string& name, vtkPolyData* mesh)
{
  std::string have;
  for (vtkDataSetAttributes* data : { static_cast<vtkDataSetAttributes*>(mesh->GetPointData()),
         static_cast<vtkDataSetAttributes*>(mesh->GetCellData()) })
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = data->GetArray(i);
      if (array && array->GetName())
      {
        if (name == array->GetName())
        {
          return Status::success();
        }
        have += (have.empty() ? "" : ", ") + std::string(array->GetName());
      }
    }
  }
  return Status::error(
    "the input has no array '" + name + "'; it has " + (have.empty() ? "none" : have));
}
}

Status checkSession(const Session& session, vtkPolyData* mesh)
{
  for (const auto& edge : session.featureEdges)
  {
    if (std::max(edge[0], edge[1]) >= mesh->GetNumberOfPoints())
    {
      return Status::error("the feature edge " + std::to_string(edge[0]) + " " +
        std::to_string(edge[1]) + " names a point that the input does not have");
    }
  }
  return session.importanceArray.empty() ? Status::success()
                                         : checkArray(session.importanceArray, mesh);
}

void applyControl(const Session& s, vtkControlMap* control)
{
  const std::vector<std::string>& names = importanceNames();
  control->SetImportance(
    static_cast<int>(std::find(names.begin(), names.end(), s.importance) - names.begin()));
  control->SetImportanceArrayName(s.importanceArray.empty() ? nullptr : s.importanceArray.c_str());
  const std::vector<std::string>& projections = imageProjectionNames();
  control->SetImageProjection(static_cast<int>(
    std::find(projections.begin(), projections.end(), s.imageProjection) - projections.begin()));
  control->SetBandPass(s.bandPass[0], s.bandPass[1]);
  applyStrokes(s.strokes, control);
  control->SetGamma(s.gamma);
  control->SetGradation(s.gradation);
  control->SetMinimumDensity(s.minimumDensity);
  if (!same(control->GetTransferFunction(), s.transfer))
  {
    vtkNew<vtkPiecewiseFunction> function;
    for (const auto& p : s.transfer)
    {
      function->AddPoint(p.first, p.second);
    }
    control->SetTransferFunction(s.transfer.empty() ? nullptr : function.Get());
  }
}

void applySession(const Session& s, vtkGeometryRemesher* remesher)
{
  remesher->SetNumberOfPoints(s.points);
  applyControl(s, remesher->GetControlMap());
  remesher->SetFeatureAngle(s.featureAngle);
  remesher->SetNumberOfCharts(s.charts);
  applyFeatureEdges(s.featureEdges, remesher);
  applyConstraints(s.constraints, remesher);
}

Status readImage(const std::string& file, vtkSmartPointer<vtkImageData>& result)
{
  vtkSmartPointer<vtkAlgorithm> reader;
  if (fileExtension(file) == ".vti")
  {
    auto xml = vtkSmartPointer<vtkXMLImageDataReader>::New();
    xml->SetFileName(file.c_str());
    reader = xml;
  }
  else if (auto image = vtkSmartPointer<vtkImageReader2>::Take(
             vtkImageReader2Factory::CreateImageReader2(file.c_str())))
  {
    image->SetFileName(file.c_str());
    reader = image;
  }
  if (!reader || !std::ifstream(file))
  {
    return Status::error("cannot read the image '" + file + "'");
  }
  ErrorCollector errors(reader);
  reader->Update();
  auto* image = vtkImageData::SafeDownCast(reader->GetOutputDataObject(0));
  if (!errors.first().empty() || !image || image->GetNumberOfPoints() == 0)
  {
    return Status::error("cannot read the image '" + file + "'");
  }
  result = image;
  return Status::success();
}
}
