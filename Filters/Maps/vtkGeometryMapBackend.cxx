// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeometryMapBackend.h"

#include "MapRasterizer.h"

#include "vtkObjectFactory.h"

vtkGeometryMapBackend* vtkGeometryMapBackend::New()
{
  auto* result = new vtkGeometryMapBackend;
  result->InitializeObjectBase();
  return result;
}

vtkGeometryMapBackend* vtkGeometryMapBackend::NewOverride()
{
  return vtkGeometryMapBackend::SafeDownCast(
    vtkObjectFactory::CreateInstance("vtkGeometryMapBackend"));
}

stipple::Status vtkGeometryMapBackend::Initialize()
{
  return stipple::Status::success();
}

stipple::Status vtkGeometryMapBackend::DrawFaces(
  const stipple::MapChart& chart, int width, int height, int* faces)
{
  stipple::rasterizeFaces(chart, width, height, faces);
  stipple::fillUncoveredPixels(chart, width, height, faces);
  return stipple::Status::success();
}

stipple::Status vtkGeometryMapBackend::DrawMaps(const stipple::MapChart& chart, int width,
  int height, const int* faces, const std::vector<stipple::MapRequest>& requests,
  const stipple::Progress& progress)
{
  return stipple::rasterizeMaps(chart, width, height, faces, requests, progress);
}
