// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkControlItem.h"

#include "vtkContext2D.h"
#include "vtkContextActor.h"
#include "vtkContextScene.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"
#include "vtkTransform2D.h"

vtkStandardNewMacro(vtkControlItem);

vtkControlItem* vtkControlItem::AddTo(vtkRenderer* renderer, Painter painter)
{
  vtkNew<vtkControlItem> item;
  item->Function = std::move(painter);
  vtkNew<vtkContextActor> actor;
  actor->GetScene()->AddItem(item);
  actor->GetScene()->SetRenderer(renderer);
  renderer->AddActor2D(actor);
  return item; // the scene keeps it
}

void vtkControlItem::SetPlace(const stipple::Rect& part, float scale)
{
  this->Part = part;
  this->Scale = scale;
}

bool vtkControlItem::Paint(vtkContext2D* painter)
{
  vtkNew<vtkTransform2D> toPart;
  toPart->Translate(-this->Part.x, -this->Part.y);
  painter->PushMatrix();
  painter->AppendTransform(toPart);
  stipple::Canvas canvas(painter, this->Scale, this->Scene->GetRenderer()->GetErase() != 0);
  this->Function(canvas);
  painter->PopMatrix();
  return true;
}
