// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AfterScene.h"

#include "SceneActors.h"
#include "SurfaceShading.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

namespace stipple
{
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
}

AfterScene::~AfterScene() = default;

void AfterScene::setMesh(vtkPolyData* mesh, vtkPolyData* lines)
{
  for (vtkActor* actor : { this->Mesh.Get(), this->Wires.Get() })
  {
    static_cast<vtkPolyDataMapper*>(actor->GetMapper())->SetInputData(bareSurface(mesh));
  }
  this->MeshEdge = meanEdge(mesh);
  for (int type = 0; type < 3; ++type)
  {
    static_cast<vtkPolyDataMapper*>(this->Lines[type]->GetMapper())
      ->SetInputData(backbonesOfType(lines, type));
  }
  this->showRightActors();
}

void AfterScene::setView(const ViewState& view, float lineWidth)
{
  this->View = view;
  this->LineWidth = lineWidth;
  this->showRightActors();
}

void AfterScene::setZoom(double pixelsPerLength)
{
  this->Zoom = pixelsPerLength;
  this->showRightActors();
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
  this->Mesh->SetVisibility(!this->View.wireframe);
  this->Wires->SetVisibility(this->View.wireframe);
  this->Wires->GetProperty()->SetLineWidth(this->LineWidth);
  setInspectionEdgeLook(this->Mesh->GetProperty(), this->MeshEdge * this->Zoom, this->LineWidth);
}
}
