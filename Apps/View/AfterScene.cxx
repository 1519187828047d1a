// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AfterScene.h"

#include "Backbones.h"
#include "SceneActors.h"
#include "SurfaceShading.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

namespace stipple
{
namespace
{
constexpr Color MarkMagenta = { { 0.85, 0.05, 0.75 } };
constexpr Color LostViolet = { { 0.45, 0.15, 0.85 } };
}

AfterScene::AfterScene(vtkRenderer* renderer, bool solid)
{
  vtkNew<vtkPolyData> none;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(none);
  mapper->ScalarVisibilityOff();
  this->Mesh = vtkSmartPointer<vtkActor>::New();
  this->Mesh->SetMapper(mapper);
  setSurfaceLook(this->Mesh->GetProperty());
  addPlainLight(this->Mesh);
  this->Mesh->GetProperty()->SetBackfaceCulling(solid);
  renderer->AddActor(this->Mesh);
  this->Wires = wireActor(none);
  renderer->AddActor(this->Wires);
  for (int type = 0; type < 3; ++type)
  {
    this->Lines[type] =
      lineActor(none, type == 0 ? FeatureRed : (type == 1 ? BoundaryBlue : Ink), 1);
    renderer->AddActor(this->Lines[type]);
  }
  this->Lost = lineActor(none, LostViolet, 1);
  renderer->AddActor(this->Lost);
  this->Mark = lineActor(none, MarkMagenta, 1);
  renderer->AddActor(this->Mark);
}

AfterScene::~AfterScene() = default;

void AfterScene::setMesh(vtkPolyData* mesh, vtkPolyData* lines, const MeshColors& colors)
{
  this->Surface = bareSurface(mesh);
  this->Colors = &colors;
  this->setMarked(-1);
  for (vtkActor* actor : { this->Mesh.Get(), this->Wires.Get() })
  {
    static_cast<vtkPolyDataMapper*>(actor->GetMapper())->SetInputData(this->Surface);
  }
  this->MeshEdge = meanEdge(mesh);
  this->paintTriangles();
  for (int type = 0; type < 3; ++type)
  {
    static_cast<vtkPolyDataMapper*>(this->Lines[type]->GetMapper())
      ->SetInputData(backbonesOfType(lines, type));
  }
  this->showRightActors();
}

void AfterScene::setLost(vtkPolyData* lines)
{
  vtkNew<vtkPolyData> none;
  static_cast<vtkPolyDataMapper*>(this->Lost->GetMapper())->SetInputData(lines ? lines : none);
  this->showRightActors();
}

vtkActor* AfterScene::lost()
{
  return this->Lost;
}

void AfterScene::paintTriangles()
{
  auto* mapper = static_cast<vtkPolyDataMapper*>(this->Mesh->GetMapper());
  const std::vector<float> none;
  const std::vector<float>& values =
    this->Colors ? valuesOf(*this->Colors, this->View.coloring) : none;
  setShading(this->Mesh->GetProperty(), !values.empty());
  mapper->ScalarVisibilityOff();
  if (values.empty())
  {
    return;
  }
  this->Surface->GetCellData()->SetScalars(
    scaleOf(*this->Colors, this->View.coloring).colorsOf(values));
  mapper->SetScalarModeToUseCellData();
  mapper->SetColorModeToDirectScalars();
  mapper->ScalarVisibilityOn();
}

void AfterScene::setMarked(int cell)
{
  this->Marked = cell;
  vtkNew<vtkPolyData> outline;
  if (cell >= 0 && this->Surface)
  {
    vtkIdType size;
    const vtkIdType* ids;
    this->Surface->GetPolys()->GetCellAtId(cell, size, ids);
    vtkNew<vtkCellArray> lines;
    lines->InsertNextCell(size, ids);
    lines->UpdateCellCount(static_cast<int>(size) + 1);
    lines->InsertCellPoint(ids[0]);
    outline->SetPoints(this->Surface->GetPoints());
    outline->SetLines(lines);
  }
  static_cast<vtkPolyDataMapper*>(this->Mark->GetMapper())->SetInputData(outline);
  this->Mark->SetVisibility(outline->GetNumberOfLines() > 0);
}

void AfterScene::setView(const ViewState& view, float lineWidth)
{
  const bool colored = view.coloring != this->View.coloring;
  this->View = view;
  if (colored)
  {
    this->paintTriangles();
  }
  this->LineWidth = lineWidth;
  this->showRightActors();
}

void AfterScene::setZoom(double pixelsPerLength)
{
  this->Zoom = pixelsPerLength;
  this->showRightActors();
}

bool AfterScene::hidesEdges() const
{
  return this->Surface && !this->View.wireframe &&
    !showsInspectionEdges(this->MeshEdge * this->Zoom);
}

void AfterScene::showRightActors()
{
  for (int type = 0; type < 3; ++type)
  {
    auto* lines = vtkPolyData::SafeDownCast(this->Lines[type]->GetMapper()->GetInput());
    const bool on = type == 2 ? this->View.seams : this->View.features;
    this->Lines[type]->SetVisibility(on && lines && lines->GetNumberOfLines() > 0);
    this->Lines[type]->GetProperty()->SetLineWidth((type == 2 ? 1.5F : 2.5F) * this->LineWidth);
  }
  auto* lost = vtkPolyData::SafeDownCast(this->Lost->GetMapper()->GetInput());
  this->Lost->SetVisibility(this->View.features && lost->GetNumberOfLines() > 0);
  this->Lost->GetProperty()->SetLineWidth(4.5F * this->LineWidth);
  this->Mark->GetProperty()->SetLineWidth(4 * this->LineWidth);
  this->Mesh->SetVisibility(!this->View.wireframe);
  this->Wires->SetVisibility(this->View.wireframe);
  this->Wires->GetProperty()->SetLineWidth(this->LineWidth);
  setInspectionEdgeLook(this->Mesh->GetProperty(), this->MeshEdge * this->Zoom, this->LineWidth);
}
}
