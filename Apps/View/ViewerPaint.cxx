// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What is written into the window's parts, and where.
#include "Viewer.h"

#include "ColorBar.h"
#include "SceneActors.h"
#include "SessionEdits.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace stipple
{
namespace
{
constexpr float Pad = 14;
constexpr float TitleHeight = 32;
constexpr Shade TitleGround{ 255, 255, 255, 205 };

/// What of a cell of the strip is below its title.
Rect content(const Rect& cell, float s)
{
  return { cell.x + Pad * s, cell.y + 8 * s, cell.w - 2 * Pad * s,
    cell.h - (TitleHeight + 10) * s };
}

/// `what` in the singular; "s" and what follows stand behind.
std::string groupedCount(long long number, const char* what, const char* rest = "")
{
  return grouped(number) + " " + what + (number == 1 ? "" : "s") + rest;
}
}

void Viewer::placeControls()
{
  const Layout& l = this->Window.layout();
  this->Controls.setBox(l.panel, l.scale);
  this->Sheet.setBox(content(l.sheet, l.scale));
  this->Curve.setBox(content(l.curve, l.scale));
  this->Figures.setBox(content(l.figures, l.scale));
  this->BeforeSide.setView(this->View, l.scale);
  this->AfterSide.setView(this->View, l.scale);
  this->updateZoom();
}

std::string Viewer::countsOfMesh(bool inTriangles) const
{
  const vtkIdType quads = this->Mesh->figures.quads;
  const vtkIdType cells = this->Mesh->mesh->GetNumberOfPolys();
  return groupedCount(this->Mesh->mesh->GetNumberOfPoints(), "point", ", ") +
    (quads > 0 && !inTriangles ? groupedCount(quads, "quad", ", ") : "") +
    groupedCount(inTriangles ? cells + quads : cells - quads, "triangle");
}

void Viewer::paintView(Canvas& canvas, bool before)
{
  const float s = canvas.scale();
  const Layout& l = this->Window.layout();
  Rect view = before ? l.before : l.after;
  if (!before && this->View.oneView)
  {
    view.x += this->View.wipe * view.w;
    view.w *= 1 - this->View.wipe;
    canvas.fill({ view.x, view.y, 2 * s, view.h }, shades::Accent);
    canvas.fill({ view.x, view.y + 0.5F * view.h - 22 * s, 8 * s, 44 * s }, shades::Accent);
  }
  std::string title;
  std::string detail;
  if (before)
  {
    const char* titles[] = { "samples", "input", "charts", "density" };
    const bool ready = this->HasAtlas && !this->View.wireframe;
    title = ready ? titles[static_cast<int>(this->View.display)] : "input";
    detail = !ready || this->View.display == Display::Input
      ? groupedCount(this->Picker->numberOfPoints(), "point", ", ") +
        groupedCount(this->Input->GetNumberOfPolys() + this->Input->GetNumberOfStrips(), "face")
      : this->View.display == Display::Density ? ""
      : this->View.display == Display::Charts
      ? groupedCount(this->BeforeSide.numberOfCharts(), "chart")
      : this->showsVertices() && this->View.display == Display::Samples &&
        this->Now.text("select_array").empty()
      ? groupedCount(this->Mesh->mesh->GetNumberOfPoints(), "sample", ", as the mesh has them")
      : this->Shown ? groupedCount(this->Shown->numberOfSamples, "sample")
                    : this->Doing.sampleNote();
  }
  else
  {
    title = "mesh";
    detail = this->Mesh ? this->countsOfMesh() : "";
  }
  if (before ? this->BeforeSide.hidesEdges() : this->AfterSide.hidesEdges())
  {
    detail += ", zoom in for edges";
  }
  else if (before && this->Shown &&
    this->BeforeSide.hidesDots(this->edgeOf(this->Shown->numberOfSamples)))
  {
    detail += ", zoom in for dots";
  }
  const float y = view.top() - 18 * s;
  const TextLook bold{ 15, shades::Word, Align::Left, true };
  // Readable before a model that reaches up to it, and whole where the line between both models
  // leaves too little room.
  const TextLook quiet{ 12, shades::Quiet };
  const float words = canvas.textWidth(title, bold) + canvas.textWidth(detail, quiet) + 10 * s;
  const float left = this->View.oneView ? std::min(view.x + Pad * s, view.right() - Pad * s - words)
                                        : view.x + Pad * s;
  canvas.fill({ left - 6 * s, y - 13 * s, words + 14 * s, 26 * s }, TitleGround);
  canvas.text(left, y, title, bold);
  canvas.text(left + canvas.textWidth(title, bold) + 10 * s, y, detail, quiet);
  if (const auto bar = this->barOf(before))
  {
    paintColorBar(canvas, view, *bar);
  }
  if (!before)
  {
    canvas.text(view.right() - Pad * s, y, this->Doing.note(),
      { 12, this->Doing.works() ? shades::Accent : shades::Alarm, Align::Right, true });
  }
  if (!before && !this->View.oneView && view.x > 0)
  {
    canvas.rule(view.x + 1, view.y, view.x + 1, view.top(), shades::Line);
  }
  else if (!before && !this->View.oneView)
  {
    canvas.rule(view.x, view.top() - 1, view.right(), view.top() - 1, shades::Line);
  }
}

std::optional<ColorBar> Viewer::barOf(bool before) const
{
  if (this->View.wireframe)
  {
    return {};
  }
  if (before && this->Shown && this->View.display == Display::Density)
  {
    return densityBar();
  }
  if (before && this->Mesh && showsMissed(this->View))
  {
    return missedScale(this->Mesh->colors).bar;
  }
  if (!before && this->Mesh && this->View.coloring != MeshColoring::Plain)
  {
    return scaleOf(this->Mesh->colors, this->View.coloring).bar;
  }
  return {};
}

void Viewer::paintStrip(Canvas& canvas)
{
  const float s = canvas.scale();
  const Layout& l = this->Window.layout();
  if (canvas.empty())
  {
    canvas.fill(l.strip, shades::Ground);
    canvas.rule(l.strip.x, l.strip.top() - 1, l.strip.right(), l.strip.top() - 1, shades::Line);
  }
  struct Cell
  {
    const Rect& box;
    const char* title;
    const char* remark;
    Control& control;
  };
  const std::string why = whyImportanceRests(this->Now);
  const std::string rests = !why.empty()        ? "not while " + why
    : this->Now.text("importance") == "uniform" ? "not for uniform"
                                                : "";
  const std::string paint =
    why.empty() ? "dark: many samples; paint here too" : "paint: not while " + why;
  const Cell cells[] = { { l.sheet, "control map", paint.c_str(), this->Sheet },
    { l.curve, "transfer function", rests.c_str(), this->Curve },
    { l.figures, "mesh quality",
      this->Mesh && this->Mesh->figures.quads > 0 ? "quads as two triangles each" : "",
      this->Figures } };
  // One of the cells that have changed, where it does not have to be all: the next frame, and the
  // frame of a preview, come the sooner.
  constexpr int NumberOfCells = 3;
  for (int i = 0; i < NumberOfCells; ++i)
  {
    const int index = (this->NextCell + i) % NumberOfCells;
    const Cell& cell = cells[index];
    Rect below = cell.box; // the strip's upper rule
    below.h -= 2 * s;
    const bool painted = this->ShownStrip.update(canvas, below, [&](Canvas& c) {
      const float y = cell.box.top() - 18 * s;
      c.text(cell.box.x + Pad * s, y, cell.title, { 13, shades::Word, Align::Left, true });
      const TextLook quiet{ 11, shades::Quiet, Align::Right };
      const float left =
        cell.box.w - 3 * Pad * s - c.textWidth(cell.title, { 13, shades::Word, Align::Left, true });
      c.text(cell.box.right() - Pad * s, y, c.fitted(cell.remark, left, quiet), quiet);
      if (cell.box.x > 0)
      {
        const float x = cell.box.x + 0.5F;
        c.rule(x, l.strip.y + 10 * s, x, l.strip.top() - 10 * s, shades::Line);
      }
      cell.control.paint(c);
    });
    if (painted && !canvas.empty())
    {
      this->NextCell = (index + 1) % NumberOfCells;
      this->StripIsOld = true;
      break;
    }
  }
}

std::string Viewer::remark() const
{
  if (!this->meshIsCurrent())
  {
    return "";
  }
  const vtkIdType cut = this->Mesh->figures.cutEdges;
  const int lost = this->Mesh->figures.lostFeatureEdges;
  const vtkIdType quads = this->Mesh->figures.quads;
  const bool fewQuads =
    this->Now.text("pattern") == "quads" && 2 * quads < this->Mesh->mesh->GetNumberOfPolys();
  const char* fewQuadsWhy = this->Now.text("importance") == "uniform"
    ? " Few quads: beside features and seams are triangles."
    : " Few quads: sizes differ; importance uniform gives more.";
  const bool tooLong = this->Now.number("edge_length") > this->Input->GetLength();
  const std::string facts = std::string(fewQuads ? fewQuadsWhy : "") +
    (tooLong ? " Edges longer than the model: as few points as charts and features take." : "") +
    (cut > 0 ? " Cut apart: " + groupedCount(cut, "edge", " of more than two triangles.") : "") +
    (lost > 0 ? " Lost (violet): " +
          groupedCount(lost, "feature edge", " of the input, for want of room; Shift+G goes there.")
              : "");
  const std::string why = whyImportanceRests(this->Now);
  const bool isGiven =
    this->Now.text("importance") != "uniform" || !this->Now.list("strokes").empty();
  return !facts.empty() || why.empty() || !isGiven // the strip tells it, too
    ? facts
    : " Importance and paint do not count while " + why + ".";
}

void Viewer::paintStatus(Canvas& canvas)
{
  const float s = canvas.scale();
  const Rect& bar = this->Window.layout().status;
  const float y = bar.y + 0.5F * bar.h;
  canvas.fill(bar, { 228, 231, 236 });
  canvas.rule(bar.x, bar.top() - 1, bar.right(), bar.top() - 1, shades::Line);
  // What the user asked for is answered; what goes on, what Return does and problems follow.
  // A control that the pointer has come to since says what it is meanwhile, be it the one that
  // mends the problem.
  const bool hints =
    this->Hinting == HintTurn::First && !this->Doing.waits() && !this->Doing.works();
  const bool goesOn =
    !hints && (this->Doing.alarms() || this->Doing.waits() || this->Doing.works());
  const bool alarm = !hints && (this->Doing.alarms() || this->MessageAlarm);
  std::string words = hints ? this->Hint : this->Message;
  const std::string doing = this->Doing.sentence();
  if (words.empty() || goesOn)
  {
    words += words.empty() || doing.empty() ? doing : " " + doing;
  }
  if (words.empty() && this->Hinting != HintTurn::Over)
  {
    words = this->Hint;
  }
  if (words.empty())
  {
    char text[128];
    std::snprintf(text, sizeof(text), "Mesh in %.2f s, preview in %.0f ms.",
      this->Mesh ? this->Mesh->seconds : 0., 1e3 * this->previewSeconds());
    words = this->TimesHidden ? "Ready." : (this->Mesh ? text : "");
    words += this->remark();
  }
  const float right = bar.right() - Pad * s;
  const std::string hint = "h: keys";
  canvas.text(right, y, hint, { 11.5F, shades::Quiet, Align::Right });
  float end = right - 70 * s;
  if (this->Doing.showsBar())
  {
    const Rect line{ end - 160 * s, y - 3 * s, 160 * s, 6 * s };
    canvas.fill(line, shades::Line);
    canvas.fill({ line.x, line.y,
                  line.w * static_cast<float>(std::clamp(this->Doing.progress, 0.02, 1.)), line.h },
      shades::Accent);
    end = line.x - 12 * s;
  }
  const TextLook look{ 12, alarm ? shades::Alarm : shades::Word };
  canvas.text(bar.x + Pad * s, y, canvas.fitted(words, end - bar.x - Pad * s, look), look);
}
}
