// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The keys.
#include "Viewer.h"

#include "CameraMoves.h"
#include "SurfacePicker.h"

#include "vtkPolyData.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cstdio>

namespace stipple
{
bool Viewer::key(const KeyStroke& stroke)
{
  if (const std::shared_ptr<Page> page = this->Asked)
  {
    page->key(stroke);
    this->Window.touch(ViewerWindow::Overlay);
    return true;
  }
  if (this->Focus)
  {
    const bool taken = this->Focus->key(stroke);
    this->Window.touch(ViewerWindow::PanelPart);
    if (this->Focus && !this->Focus->wantsKeys())
    {
      this->Focus = nullptr;
    }
    if (taken)
    {
      return true;
    }
  }
  if (stroke.control)
  {
    return this->commandKey(stroke);
  }
  const auto setTool = [this](Tool tool) {
    this->changeView([tool](ViewState& v) { v.tool = tool; });
    return true;
  };
  const std::string& key = stroke.symbol;
  if (key == "v" || key == "b" || key == "k" || key == "x")
  {
    return setTool(key == "v" ? Tool::Camera
        : key == "b"          ? Tool::Brush
        : key == "k"          ? Tool::Point
                              : Tool::Edge);
  }
  if (key == "h")
  {
    this->changeView([](ViewState& v) { v.help = !v.help; });
  }
  else if (key == "d")
  {
    this->changeView([](ViewState& v) {
      v.show(static_cast<Display>((static_cast<int>(v.display) + (v.wireframe ? 0 : 1)) % 4));
    });
  }
  else if (key == "l")
  {
    this->changeView([](ViewState& v) { v.features = !v.features; });
  }
  else if (key == "m")
  {
    this->changeView([](ViewState& v) { v.seams = !v.seams; });
  }
  else if (key == "bracketleft" || key == "bracketright")
  {
    this->changeView([&key](ViewState& v) {
      v.brushRadius =
        std::clamp(v.brushRadius * (key == "bracketleft" ? 0.8 : 1.25), LeastBrush, LargestBrush);
    });
  }
  else if (key == "p" || key == "P")
  {
    if (this->View.tool == Tool::Brush)
    {
      this->fillRegion(key == "P");
    }
    else
    {
      this->say("p fills a region with paint: take the brush first (b).");
    }
  }
  else if (key == "y")
  {
    this->changeView(
      [](ViewState& v) { v.brushMirror = v.brushMirror == 2 ? -1 : v.brushMirror + 1; });
    const int axis = this->View.brushMirror;
    this->say(axis < 0 ? "Strokes are not mirrored any more."
                       : std::string("Strokes are mirrored in ") + "xyz"[axis] + ".");
  }
  else if (key == "c")
  {
    this->changeView([](ViewState& v) {
      v.colorBy(
        static_cast<MeshColoring>((static_cast<int>(v.coloring) + (v.wireframe ? 0 : 1)) % 4));
    });
  }
  else if (key == "g")
  {
    this->goToWorst();
  }
  else if (key == "G")
  {
    this->goToLost();
  }
  else if (key == "w" || key == "s")
  {
    this->changeView([&key](ViewState& v) { v.wireframe = key == "w" && !v.wireframe; });
  }
  else if (key == "X" || key == "Y" || key == "Z")
  {
    this->lookAlong(key[0] - 'X');
  }
  else if (key == "u")
  {
    this->View.zUp = !this->View.zUp;
    this->resetCamera();
    this->say(this->View.zUp ? "z is up." : "y is up.");
  }
  else if (key == "o")
  {
    this->changeView([](ViewState& v) { v.oneView = !v.oneView; });
  }
  else if (key == "r")
  {
    this->fitCamera();
  }
  else if (key == "R")
  {
    this->resetCamera();
  }
  else if (key == "q")
  {
    this->askToQuit();
  }
  else if (key == "n")
  {
    if (this->Controls.scroll(1000))
    {
      this->Window.renew();
    }
    this->Controls.points().focus();
    this->setFocus(&this->Controls.points());
    this->Window.touch(ViewerWindow::PanelPart);
  }
  else if (key == "Return" || key == "KP_Enter")
  {
    this->makeMesh();
  }
  else if (key == "Escape")
  {
    if (this->View.help)
    {
      this->changeView([](ViewState& v) { v.help = false; });
    }
    else if (!this->Reading.empty())
    {
      this->giveUpReading();
    }
    else if (this->Worker.busy() || this->MeshWanted || this->Sampler.waiting() > 0)
    {
      this->Worker.cancel();
      this->Sampler.cancel();
      this->MeshWanted = false;
      this->AfterSaving = nullptr;
      this->Stopped = true;
      this->say("");
    }
  }
  else
  {
    return false;
  }
  return true;
}

bool Viewer::commandKey(const KeyStroke& stroke)
{
  if (stroke.symbol == "z" || stroke.symbol == "Z")
  {
    stroke.shift ? this->redo() : this->undo();
  }
  else if (stroke.symbol == "y")
  {
    this->redo();
  }
  else if (stroke.symbol == "q")
  {
    this->askToQuit();
  }
  else if (stroke.symbol == "o")
  {
    this->openFile();
  }
  else if (stroke.symbol == "e")
  {
    this->saveFigures();
  }
  else if (stroke.symbol == "S" || (stroke.symbol == "s" && stroke.shift))
  {
    this->saveMeshAs();
  }
  else if (stroke.symbol == "s")
  {
    this->saveMesh();
  }
  else if (stroke.symbol == "p")
  {
    this->savePicture();
  }
  else if (stroke.symbol == "j")
  {
    this->saveSession();
  }
  else
  {
    return false;
  }
  return true;
}

void Viewer::goToWorst()
{
  const MeshColoring coloring = this->View.coloring;
  const std::vector<int> worst =
    this->Mesh ? worstOf(this->Mesh->colors, coloring) : std::vector<int>();
  if (worst.empty())
  {
    this->say("There is no mesh yet.");
    return;
  }
  const std::size_t place = this->AfterSide.marked() < 0 ? 0 : (this->NextWorst % worst.size());
  this->NextWorst = place + 1;
  const int cell = worst[place];
  this->AfterSide.setMarked(cell);
  lookAt(this->Window.renderer(ViewerWindow::After)->GetActiveCamera(), this->Mesh->mesh, cell,
    this->Solid);
  this->showMeshInMiddle();
  this->updateZoom();
  this->Window.touch(ViewerWindow::Views);
  const auto at = static_cast<std::size_t>(cell);
  const MeshColors& colors = this->Mesh->colors;
  char figure[64];
  coloring == MeshColoring::Deviation
    ? std::snprintf(
        figure, sizeof(figure), "%.3g %% of the diagonal from the input", colors.deviation[at])
    : coloring == MeshColoring::Quality
    ? std::snprintf(figure, sizeof(figure), "quality %.3f", colors.quality[at])
    : std::snprintf(figure, sizeof(figure), "smallest angle %.1f\u00b0", colors.angle[at]);
  std::string more;
  if (const double missed = largestOf(colors.missed);
      coloring == MeshColoring::Deviation && missed > colors.deviation[at])
  {
    char other[96];
    std::snprintf(other, sizeof(other), " The input is up to %.3g %% from the mesh.", missed);
    more = other;
  }
  this->say("Triangle " + std::to_string(cell) + ": " + figure + "; " + std::to_string(place + 1) +
    " of the " + std::to_string(worst.size()) + " worst." + more);
}

void Viewer::showMeshInMiddle()
{
  constexpr float MostOfWipe = 0.3F; // of the view's width, which leaves as much about the middle
  if (this->View.oneView && this->View.wipe > MostOfWipe)
  {
    this->changeView([](ViewState& v) { v.wipe = MostOfWipe; });
  }
}

void Viewer::goToLost()
{
  vtkPolyData* lost = this->Mesh ? this->Mesh->lost.Get() : nullptr;
  const vtkIdType number = lost ? lost->GetNumberOfLines() : 0;
  if (number == 0)
  {
    this->say(this->Mesh ? "No feature edge is lost." : "There is no mesh yet.");
    return;
  }
  const vtkIdType edge = this->NextLost % number;
  this->NextLost = edge + 1;
  double bounds[6];
  lost->GetCellBounds(edge, bounds);
  const Vec3 middle =
    0.5 * Vec3(bounds[0] + bounds[1], bounds[2] + bounds[3], bounds[4] + bounds[5]);
  if (!this->View.features)
  {
    this->changeView([](ViewState& v) { v.features = true; });
  }
  constexpr double Nearer = 0.5; // than at a triangle: it is at an edge, and what is about it
  lookAt(this->Window.renderer(ViewerWindow::After)->GetActiveCamera(), this->Input, middle,
    Nearer * this->edgeOf(this->Mesh->mesh->GetNumberOfPoints()),
    this->Picker->nearest(middle).normal);
  this->showMeshInMiddle();
  this->updateZoom();
  this->Window.touch(ViewerWindow::Views);
  this->say("Lost (violet): feature edge " + std::to_string(edge + 1) + " of " +
    std::to_string(number) + ".");
}
}
