// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkQuadRemesh.h"

#include "MeshCreation.h"
#include "QuadPattern.h"

#include "vtkCellArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkQuadRemesh);

struct vtkQuadRemesh::Internals
{
  stipple::SurfaceCache Atlas;
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
  vtkPolyData* sampleData = vtkPolyData::GetData(inputVector[0]);
  auto* charts = vtkPartitionedDataSetCollection::GetData(inputVector[1]);
  vtkPolyData* featureGraph = vtkPolyData::GetData(inputVector[2]);
  if (!sampleData || !charts || sampleData->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  stipple::SurfaceCache& atlas = this->Implementation->Atlas;
  std::vector<stipple::Sample> samples;
  stipple::QuadMesh mesh;
  stipple::Status status = atlas.update(charts, featureGraph);
  if (status.ok())
  {
    status = stipple::readSamples(sampleData, atlas.surface(), samples);
  }
  if (status.ok())
  {
    status = stipple::meshWithQuads(atlas, samples, mesh, [this](double fraction) {
      this->UpdateProgress(fraction);
      return this->GetAbortExecute() == 0;
    });
  }
  if (status.isAbort())
  {
    return 1;
  }
  if (!status.ok())
  {
    vtkErrorMacro(<< status.message());
    return 0;
  }
  // Cell arrays come from one triangle of every polygon.
  std::vector<stipple::Triangle> triangles;
  for (const std::vector<int>& p : mesh.polygons)
  {
    triangles.push_back({ p[0], p[1], p[2] });
  }
  const auto result = stipple::meshToPolyData(atlas, mesh.samples, triangles);
  setPolygons(mesh, result);
  const auto lines = stipple::featureLines(
    atlas.graph(), stipple::backboneChains(atlas.graph(), mesh.samples), result, true);
  vtkPolyData::GetData(outputVector, 0)->ShallowCopy(result);
  vtkPolyData::GetData(outputVector, 1)->ShallowCopy(lines);
  this->UpdateProgress(1.);
  return 1;
}

void vtkQuadRemesh::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Atlas read: " << this->Implementation->Atlas.generation() << " times\n";
}
