// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What the controls and keys ask the viewer for.
#include "Viewer.h"

#include "MeshFile.h"
#include "OutputFiles.h"
#include "SceneActors.h"
#include "Session.h"

#include "vtkPolyData.h"

#include <utility>

namespace stipple
{
namespace
{
/// Pixels of the pictures of a view alone.
constexpr int FigureHeight = 2000;
}

void Viewer::edit(const std::function<void(Session&)>& change, bool rests)
{
  const Session before = this->Now;
  change(this->Now);
  if (!this->Editing)
  {
    this->EditBase = before;
    this->Editing = true;
    this->Unwritten.clear();
  }
  if (rests)
  {
    this->Editing = false;
    if (this->Now != this->EditBase)
    {
      this->Edits.add(this->EditBase);
    }
  }
  if (this->Now != before)
  {
    this->changed(rests);
  }
  else if (rests)
  {
    // The value came with the last move; now it rests.
    this->MeshAt = Clock::now();
    this->showSession();
  }
}

void Viewer::changeView(const std::function<void(ViewState&)>& change)
{
  const bool help = this->View.help;
  const MeshColoring coloring = this->View.coloring;
  const Display display = this->View.display;
  change(this->View);
  this->PreviewIsOld =
    this->PreviewIsOld || (this->View.display != display && this->View.display == Display::Density);
  this->NextWorst = this->View.coloring == coloring ? this->NextWorst : 0; // of others
  if (this->View.help != help)
  {
    this->Window.showOverlay(this->View.help);
  }
  const Rect before = this->Window.layout().before;
  if (this->Window.setOneView(this->View.oneView, this->View.wipe))
  {
    this->takePlaces(before);
  }
  const float lines = this->Window.layout().scale;
  this->BeforeSide.setView(this->View, lines);
  this->AfterSide.setView(this->View, lines);
  if (this->View.tool == Tool::Camera)
  {
    this->BeforeSide.hideBrush();
  }
  this->renewHint();
  this->Window.touch(ViewerWindow::Views);
  this->LastTagged = this->View.tool == Tool::Edge ? this->LastTagged : -1;
  this->showSession();
}

void Viewer::clear(Clear what)
{
  this->edit(
    [what](Session& s) {
      switch (what)
      {
        case Clear::Paint:
          s.reset("strokes");
          break;
        case Clear::Points:
          s.reset("constraints");
          break;
        case Clear::Edges:
          s.reset("feature_edges");
          break;
      }
    },
    true);
}

void Viewer::undo()
{
  if (this->Edits.canUndo() && !this->Editing)
  {
    this->Unwritten.clear();
    this->Edits.undo(this->Now);
    this->changed(true);
  }
}

void Viewer::redo()
{
  if (this->Edits.canRedo() && !this->Editing)
  {
    this->Unwritten.clear();
    this->Edits.redo(this->Now);
    this->changed(true);
  }
}

void Viewer::saveMesh()
{
  this->replaceFirst(this->Files.mesh, [this] { this->writeMesh(); });
}

void Viewer::writeMesh()
{
  if (!this->Problem.empty()) // there is no mesh to wait for
  {
    this->say(this->meshFile() + " is not written.", true); // the activity says why
    return;
  }
  if (!this->meshIsCurrent())
  {
    this->SaveWhenDone = true;
    this->SavesMeshOf = this->Now;
    this->say(""); // the activity tells it
    return;
  }
  this->SaveWhenDone = false;
  Status status = OutputFiles::check(this->Files.mesh);
  OutputFiles files;
  if (status.ok())
  {
    status = writeRemesh(this->Mesh->mesh, files.aside(this->Files.mesh), this->Files.mesh);
  }
  if (status.ok())
  {
    status = files.commit();
  }
  if (status.ok())
  {
    this->Written = this->Now;
  }
  const std::function<void()> next = std::exchange(this->AfterSaving, nullptr);
  this->say(status.ok() ? "Wrote " + wholePath(this->Files.mesh) + ": " +
        this->countsOfMesh(fileExtension(this->Files.mesh) == ".stl") + this->reachedDistance() +
        "."
                        : status.message(),
    !status.ok());
  if (next && status.ok())
  {
    next();
  }
}

void Viewer::savePicture()
{
  this->replaceFirst(this->Files.picture, [this] { this->writePictureFile(); });
}

void Viewer::writePictureFile()
{
  if (this->Window.dirty() || this->Window.rough())
  {
    this->Window.draw(true);
  }
  const Status status = this->writePicture(this->Files.picture);
  this->say(
    status.ok() ? "Wrote " + wholePath(this->Files.picture) + "." : status.message(), !status.ok());
}

void Viewer::saveFigures()
{
  this->replaceFirst(this->Files.figures + "-before.png", [this] {
    this->say("Drawing the figures ...");
    this->AfterDraw = [this] { this->writeFigureFiles(); };
  });
}

void Viewer::writeFigureFiles()
{
  OutputFiles files;
  Status status = Status::success();
  // Lines are as wide as they are here, next to the model.
  const Layout& layout = this->Window.layout();
  const float lines = layout.scale * FigureHeight / layout.before.h;
  this->BeforeSide.setView(this->View, lines);
  this->AfterSide.setView(this->View, lines);
  const int marked = this->AfterSide.marked();
  this->AfterSide.setMarked(-1); // not the figure's, nor is the brush
  this->BeforeSide.hideBrush();
  for (const bool before : { true, false })
  {
    const std::string file = this->Files.figures + (before ? "-before.png" : "-after.png");
    status = status.ok() ? OutputFiles::check(file) : status;
    if (status.ok())
    {
      const std::optional<ColorBar> bar = this->barOf(before);
      const auto legend = [&bar](Canvas& canvas, const Rect& view, const Covered& covered) {
        if (bar)
        {
          paintColorBar(canvas, view, *bar, covered);
        }
      };
      status = this->Window.writeFigure(before ? ViewerWindow::Before : ViewerWindow::After,
        FigureHeight, legend, files.aside(file));
    }
  }
  if (status.ok())
  {
    status = files.commit();
  }
  this->AfterSide.setMarked(marked);
  this->placeControls();
  const std::string name = wholePath(this->Files.figures);
  const bool isOld = this->Mesh && !this->meshIsCurrent();
  this->say(status.ok()
      ? "Wrote " + name + "-before.png and -after.png, " + std::to_string(FigureHeight) +
        " pixels high, transparent" + (isOld ? "; the mesh is one of before." : ".")
      : status.message(),
    !status.ok() || isOld);
}

void Viewer::saveSession()
{
  this->replaceFirst(this->Files.session, [this] { (void)this->writeSessionFile(); });
}

bool Viewer::writeSessionFile()
{
  if (this->Now.text("model").empty())
  {
    this->say("The example is in no file, and a session names one: open a file of yours.", true);
    return false;
  }
  Status status = OutputFiles::check(this->Files.session);
  OutputFiles files;
  if (status.ok())
  {
    status = writeSession(this->Now, files.aside(this->Files.session), this->Files.session);
  }
  if (status.ok())
  {
    status = files.commit();
  }
  if (status.ok())
  {
    this->Saved = this->Now;
    this->NewSession = wholePath(this->Files.session);
    this->renewTitle();
  }
  this->say(
    status.ok() ? "Wrote " + wholePath(this->Files.session) + "." : status.message(), !status.ok());
  return status.ok();
}
}
