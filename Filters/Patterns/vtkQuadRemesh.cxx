// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkQuadRemesh.h"

#include "FilterInputs.h"
#include "MeshCreation.h"
#include "QuadPattern.h"
#include "RegionTransfer.h"

#include "vtkCellArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkQuadRemesh);

struct vtkQuadRemesh::Internals
{
  stipple::Atlas::Pointer Atlas;
};

vtkQuadRemesh::vtkQuadRemesh()
  : Implementation(new Internals)
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(2);
}

vtkQuadRemesh::~vtkQuadRemesh() = default;

int vtkQuadRemesh::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(),
    port == 1 ? "vtkPartitionedDataSetCollection" : "vtkPolyData");
  return 1;
}

namespace
{
/// The polygons in place of the triangles that stood for them.
void setPolygons(const stipple::QuadMesh& mesh, vtkPolyData* data)
{
  vtkNew<vtkCellArray> cells;
  for (const std::vector<int>& polygon : mesh.polygons)
  {
    cells->InsertNextCell(static_cast<int>(polygon.size()));
    for (int p : polygon)
    {
      cells->InsertCellPoint(p);
    }
  }
  data->SetPolys(cells);
}
}

int vtkQuadRemesh::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const stipple::FilterInputs inputs(inputVector);
  return stipple::execute(this, this->ErrorCode, [&](const stipple::Progress& progress) {
    if (inputs.isEmpty())
    {
      return stipple::Status::success();
    }
    stipple::Atlas::Pointer& atlas = this->Implementation->Atlas;
    std::vector<stipple::Sample> samples;
    stipple::QuadMesh mesh;
    stipple::Status status = inputs.read(atlas, samples);
    if (status.ok())
    {
      status = stipple::meshWithQuads(*atlas, samples, mesh, progress);
    }
    if (!status.ok())
    {
      return status;
    }
    // Cell arrays come from one triangle of every polygon.
    std::vector<stipple::Triangle> triangles;
    for (const std::vector<int>& p : mesh.polygons)
    {
      triangles.push_back({ p[0], p[1], p[2] });
    }
    const auto result = stipple::meshToPolyData(*atlas, mesh.samples, triangles);
    setPolygons(mesh, result);
    const auto chains = stipple::backboneChains(atlas->graph(), mesh.samples);
    stipple::transferRegions(*atlas, chains, result);
    const auto lines = stipple::featureLines(atlas->graph(), chains, result, true);
    vtkPolyData::GetData(outputVector, 0)->ShallowCopy(result);
    vtkPolyData::GetData(outputVector, 1)->ShallowCopy(lines);
    return status;
  });
}

void vtkQuadRemesh::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
