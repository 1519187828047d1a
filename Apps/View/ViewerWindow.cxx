// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewerWindow.h"

#include "Display.h"
#include "SceneActors.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkImageData.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPNGWriter.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace stipple
{
ViewerWindow::ViewerWindow(int width, int height)
{
  vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
  this->Window->SetSize(width, height);
  this->Window->SetWindowName("stipple");
  this->Window->SetMultiSamples(0); // four times as slow without graphics hardware; see draw()
  if (auto* window = vtkOpenGLRenderWindow::SafeDownCast(this->Window))
  {
    // Only colors go to the screen: depths would take as long without graphics hardware.
    window->SetFrameBlitModeToBlitToCurrent();
  }
  this->Window->SetNumberOfLayers(2);
  for (int i = 0; i < NumberOfParts; ++i)
  {
    const int part = 1 << i;
    vtkRenderer* renderer = this->Renderers[i];
    const Shade& ground = part & Views ? shades::Card : shades::Ground;
    renderer->SetBackground(ground.r / 255., ground.g / 255., ground.b / 255.);
    renderer->SetInteractive((part & Views) != 0);
    renderer->SetLayer(part == Overlay ? 1 : 0);
    this->Window->AddRenderer(renderer);
  }
  for (const Part part : { Before, After })
  {
    addInspectionLights(this->renderer(part));
  }
  this->renderer(After)->AddViewProp(this->Wipe); // before all others
  this->renderer(After)->SetActiveCamera(this->renderer(Before)->GetActiveCamera());
  this->Places = makeLayout(width, height);
  this->place();
}

ViewerWindow::~ViewerWindow() = default;

void ViewerWindow::setTitle(const std::string& name)
{
  stipple::setTitle(this->Window, name.empty() ? "stipple" : name + " - stipple");
}

vtkRenderer* ViewerWindow::renderer(Part part)
{
  int index = 0;
  while ((1 << index) != part)
  {
    ++index;
  }
  return this->Renderers[index];
}

Rect ViewerWindow::rectOf(const Layout& l, int index)
{
  const Rect rects[NumberOfParts] = { l.before, l.after, l.strip, l.panel, l.status, l.window };
  return rects[index];
}

void ViewerWindow::place()
{
  const Rect& all = this->Places.window;
  for (int i = 0; i < NumberOfParts; ++i)
  {
    const Rect part = rectOf(this->Places, i);
    this->Renderers[i]->SetViewport(
      part.x / all.w, part.y / all.h, part.right() / all.w, part.top() / all.h);
    for (vtkControlItem* item : this->Items[i])
    {
      item->SetPlace(part, this->Places.scale);
    }
  }
  this->renew();
}

void ViewerWindow::renew()
{
  this->touch(All);
  this->Kept = 0;
}

void ViewerWindow::addPainter(Part part, const vtkControlItem::Painter& painter)
{
  int index = 0;
  while ((1 << index) != part)
  {
    ++index;
  }
  this->Items[index].push_back(vtkControlItem::AddTo(this->Renderers[index], painter));
  this->Items[index].back()->SetPlace(rectOf(this->Places, index), this->Places.scale);
}

void ViewerWindow::clear()
{
  for (int i = 0; i < NumberOfParts; ++i)
  {
    this->Renderers[i]->RemoveAllViewProps();
    this->Items[i].clear();
  }
  this->renderer(After)->AddViewProp(this->Wipe);
  this->setOneView(false, 0);
  this->showOverlay(false);
}

void ViewerWindow::showOverlay(bool on)
{
  this->OverlayOn = on;
  this->renew();
}

bool ViewerWindow::resize()
{
  const int* size = this->Window->GetSize();
  if (size[0] == static_cast<int>(this->Places.window.w) &&
    size[1] == static_cast<int>(this->Places.window.h))
  {
    return false;
  }
  this->Places = makeLayout(size[0], size[1], this->OneView);
  this->place();
  return true;
}

bool ViewerWindow::setOneView(bool on, float wipe)
{
  this->Wipe->SetShare(on ? wipe : 0);
  this->renderer(After)->SetErase(!on);
  if (on == this->OneView)
  {
    return false;
  }
  this->OneView = on;
  this->Places = makeLayout(
    static_cast<int>(this->Places.window.w), static_cast<int>(this->Places.window.h), on);
  this->place();
  return true;
}

void ViewerWindow::draw(bool calm)
{
  if (this->OneView)
  {
    // The one lies over the other.
    this->Dirty |= (this->Dirty & Before) != 0 ? After : 0;
    this->Rough |= (this->Rough & Before) != 0 ? After : 0;
  }
  // What lies below the overlay is drawn with it.
  const int parts = this->OverlayOn ? All : this->Dirty & ~Overlay;
  const int smoothed = calm ? this->Rough | (parts & Views) : 0;
  this->Rough = (this->Rough | (parts & Views)) & ~smoothed;
  for (int i = 0; i < NumberOfParts; ++i)
  {
    const int part = 1 << i;
    const Rect place = rectOf(this->Places, i);
    const bool drawn = ((parts | smoothed) & part) != 0 && place.w > 0 && place.h > 0;
    this->Renderers[i]->SetDraw(drawn);
    if (drawn && (part & Views) != 0)
    {
      this->Renderers[i]->SetUseFXAA((smoothed & part) != 0);
    }
  }
  this->fitClippingRange();
  // These paint what has changed in them, over the rest.
  for (const Part part : { PanelPart, Strip })
  {
    this->renderer(part)->SetErase((this->Kept & part) == 0);
  }
  this->Kept = this->OverlayOn ? 0 : this->Kept | (parts & (PanelPart | Strip));
  this->Dirty = 0;
  this->Window->Render();
}

void ViewerWindow::fitClippingRange()
{
  vtkBoundingBox all; // one camera looks at both models
  for (const Part part : { Before, After })
  {
    double bounds[6];
    this->renderer(part)->ComputeVisiblePropBounds(bounds);
    if (vtkMath::AreBoundsInitialized(bounds))
    {
      all.AddBounds(bounds);
    }
  }
  if (all.IsValid())
  {
    double bounds[6];
    all.GetBounds(bounds);
    this->renderer(Before)->ResetCameraClippingRange(bounds);
  }
}

namespace
{
double opaquePixels(vtkImageData* image, const Rect& part)
{
  const int* size = image->GetDimensions();
  const auto from = [](float edge) { return std::max(0, static_cast<int>(edge)); };
  int number = 0;
  for (int y = from(part.y); y < std::min<int>(size[1], static_cast<int>(part.top())); ++y)
  {
    for (int x = from(part.x); x < std::min<int>(size[0], static_cast<int>(part.right())); ++x)
    {
      number += static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0))[3] > 0 ? 1 : 0;
    }
  }
  return number;
}
}

stipple::Status ViewerWindow::writeFigure(
  Part view, int height, const Legend& legend, const std::string& file)
{
  constexpr int Samples = 4;
  const Rect& place = this->Places.before; // for both: a pair is alike
  vtkRenderer* from = this->renderer(view);
  vtkNew<vtkRenderWindow> window;
  window->SetShowWindow(false);
  window->SetUseOffScreenBuffers(true);
  window->SetMultiSamples(Samples);
  window->SetAlphaBitPlanes(1);
  window->SetSize(static_cast<int>(std::lround(height * place.w / place.h)), height);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackgroundAlpha(0);
  renderer->SetActiveCamera(from->GetActiveCamera());
  addInspectionLights(renderer);
  window->AddRenderer(renderer);
  vtkPropCollection* props = from->GetViewProps();
  props->InitTraversal();
  while (vtkProp* prop = props->GetNextProp())
  {
    if (auto* actor = vtkActor::SafeDownCast(prop))
    {
      renderer->AddActor(actor);
    }
  }
  renderer->ResetCameraClippingRange();
  const Rect all{ 0, 0, static_cast<float>(window->GetSize()[0]), static_cast<float>(height) };
  window->Render();
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->SetInputBufferTypeToRGBA();
  grab->ReadFrontBufferOff();
  grab->ShouldRerenderOff();
  grab->Update();
  vtkNew<vtkImageData> model;
  model->DeepCopy(grab->GetOutput());
  vtkControlItem::AddTo(renderer, [&](Canvas& canvas) {
    legend(canvas, all, [&model](const Rect& part) { return opaquePixels(model, part); });
  })->SetPlace(all, this->Places.scale * all.h / place.h);
  window->Render();
  grab->Modified();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(grab->GetOutputPort());
  writer->SetFileName(file.c_str());
  writer->Write();
  // Each actor's buffers belong to the window that it was drawn in last.
  window->Finalize();
  this->renew();
  return writer->GetErrorCode() == 0 ? stipple::Status::success()
                                     : stipple::Status::error("cannot write '" + file + "'");
}
}
