// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The pointer and the keys.
#include "Viewer.h"

#include "CameraMoves.h"
#include "SessionEdits.h"

#include "vtkPolyData.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace stipple
{
namespace
{
/// A constraint this near to the pointer is taken away, not doubled; of the diagonal.
constexpr double NearPoint = 0.012;
/// A notch of the wheel makes everything larger by this.
constexpr double WheelZoom = 1.2;
/// Dabs of a drag are so far apart, in radii.
constexpr double DabDistance = 0.35;
}

Control* Viewer::controlAt(const Pointer& pointer)
{
  std::vector<Control*> all = this->Controls.controls();
  all.insert(all.end(), { &this->Sheet, &this->Curve, &this->Figures });
  for (Control* control : all)
  {
    if (control->box().has(pointer.x, pointer.y))
    {
      return control;
    }
  }
  return nullptr;
}

int Viewer::partOf(const Control* control) const
{
  return control == &this->Sheet || control == &this->Curve || control == &this->Figures
    ? ViewerWindow::Strip
    : ViewerWindow::PanelPart;
}

void Viewer::setFocus(Control* control)
{
  if (this->Focus && this->Focus != control)
  {
    Control* before = this->Focus;
    this->Focus = nullptr;
    before->blur();
    this->Window.touch(this->partOf(before));
  }
  this->Focus = control;
}

bool Viewer::press(const Pointer& pointer)
{
  if (const std::shared_ptr<Page> page = this->Asked)
  {
    page->press(pointer);
    this->Window.touch(ViewerWindow::Overlay);
    return true;
  }
  if (this->View.help)
  {
    this->changeView([](ViewState& v) { v.help = false; });
    return true;
  }
  Control* control = this->controlAt(pointer);
  if (this->Focus != control)
  {
    this->setFocus(nullptr);
  }
  if (control)
  {
    this->Captured = control->press(pointer) ? control : nullptr;
    this->setFocus(control->wantsKeys() ? control : nullptr);
    this->Window.touch(this->partOf(control));
    return true;
  }
  if (this->isOverWipe(pointer))
  {
    this->Wiping = true;
    return true;
  }
  const Layout& layout = this->Window.layout();
  const bool inView =
    layout.before.has(pointer.x, pointer.y) || layout.after.has(pointer.x, pointer.y);
  PickedPlace place;
  if (inView && !pointer.secondary && this->View.tool != Tool::Camera && this->pick(pointer, place))
  {
    this->useTool(place, pointer);
    return true;
  }
  return !inView;
}

bool Viewer::isOverWipe(const Pointer& pointer) const
{
  constexpr float Reach = 8;
  const Rect& view = this->Window.layout().after;
  return this->View.oneView && view.has(pointer.x, pointer.y) &&
    std::abs(pointer.x - view.x - this->View.wipe * view.w) < Reach * this->Window.layout().scale;
}

void Viewer::drag(const Pointer& pointer)
{
  if (this->Wiping)
  {
    const Rect& view = this->Window.layout().after;
    this->changeView(
      [&](ViewState& v) { v.wipe = std::clamp((pointer.x - view.x) / view.w, 0.02F, 0.98F); });
  }
  if (this->Painting)
  {
    this->paintTo(pointer);
    this->showTool(pointer);
  }
  if (this->Captured)
  {
    this->Captured->drag(pointer);
    this->Window.touch(this->partOf(this->Captured));
  }
}

void Viewer::release(const Pointer& pointer)
{
  this->Wiping = false;
  if (this->Painting)
  {
    this->Painting = false;
    this->View.brushErases = false;
    this->View.brushSmooths = false;
    this->edit([](Session&) {}, true);
  }
  if (this->Captured)
  {
    Control* control = this->Captured;
    this->Captured = nullptr;
    control->release(pointer);
    this->Window.touch(this->partOf(control));
  }
}

void Viewer::wheel(const Pointer& pointer, int notches)
{
  if (this->Asked)
  {
    this->Asked->wheel(notches);
    this->Window.touch(ViewerWindow::Overlay);
    return;
  }
  const Layout& layout = this->Window.layout();
  if (!this->View.help && layout.panel.has(pointer.x, pointer.y) && this->Controls.scroll(notches))
  {
    this->Window.renew();
    this->hover(pointer); // another control is there
  }
  const bool before = layout.before.has(pointer.x, pointer.y);
  if (this->View.help || (!before && !layout.after.has(pointer.x, pointer.y)))
  {
    return;
  }
  PickedPlace place;
  vtkRenderer* renderer =
    this->Window.renderer(before ? ViewerWindow::Before : ViewerWindow::After);
  const Vec3 center =
    this->pick(pointer, place) ? place.position : focalPlaneAt(renderer, pointer.x, pointer.y);
  zoomAbout(renderer->GetActiveCamera(), center, std::pow(WheelZoom, notches));
  this->updateZoom();
  this->Window.touch(ViewerWindow::Views);
}

void Viewer::hover(const Pointer& pointer)
{
  if (this->Asked)
  {
    this->Asked->hover(pointer);
    this->Window.touch(ViewerWindow::Overlay);
    return;
  }
  Control* control = this->controlAt(pointer);
  if (this->Under && this->Under != control && this->Under->hover(false, pointer))
  {
    this->Window.touch(this->partOf(this->Under));
  }
  this->Under = control;
  if (control && control->hover(true, pointer))
  {
    this->Window.touch(this->partOf(control));
  }
  this->LastPointer = pointer;
  this->renewHint();
  if (this->View.tool != Tool::Camera)
  {
    this->showTool(pointer);
  }
}

std::string Viewer::toolHint(const Pointer& pointer) const
{
  const Layout& layout = this->Window.layout();
  if (!layout.before.has(pointer.x, pointer.y) && !layout.after.has(pointer.x, pointer.y))
  {
    return "";
  }
  if (this->isOverWipe(pointer))
  {
    return "Drag the line: left of it the samples, right of it the mesh; o shows both again.";
  }
  switch (this->View.tool)
  {
    case Tool::Brush:
      if (const std::string why = whyImportanceRests(this->Now); !why.empty())
      {
        return "Brush: paint does not count while " + why + ".";
      }
      return std::string(
               "Brush: drag paints, Ctrl takes paint away, Shift spreads it; p fills up to "
               "features, Shift+P takes that away; y mirrors: ") +
        (this->View.brushMirror < 0 ? "no" : std::string(1, "xyz"[this->View.brushMirror])) + ".";
    case Tool::Point:
      return "Point: a click picks a point that is to be a vertex, a click on it lets it go; "
             "beside the model a drag turns it.";
    case Tool::Edge:
      return "Edge: a click tags an edge as a feature, or no more, Shift all on the way from the "
             "last one; beside the model a drag turns it.";
    default:
      return "Drag turns, Shift moves, the wheel zooms at the pointer; r shows the whole model.";
  }
}

void Viewer::renewHint()
{
  const std::string hint =
    this->Under ? this->Under->hint(this->LastPointer) : this->toolHint(this->LastPointer);
  if (hint != this->Hint)
  {
    this->Hint = hint;
    this->Hinting = this->Under && !hint.empty() ? HintTurn::First : HintTurn::Last;
    this->Window.touch(ViewerWindow::Status);
  }
}

void Viewer::showTool(const Pointer& pointer)
{
  PickedPlace place;
  const bool on = this->pick(pointer, place);
  if (this->View.tool == Tool::Edge)
  {
    this->BeforeSide.setEdgesUnder(
      on ? this->edgesAt(place, pointer.shift) : std::vector<std::array<vtkIdType, 2>>{});
  }
  else
  {
    const bool brush = this->View.tool == Tool::Brush;
    std::vector<PickedPlace> places;
    if (on)
    {
      places.push_back(place);
    }
    if (on && brush && this->View.brushMirror >= 0)
    {
      places.push_back(this->Picker->nearest(this->mirrored({ place.position }).back()));
    }
    const double radius = brush ? 0.01 * this->View.brushRadius : NearPoint;
    this->BeforeSide.setBrush(places, radius * this->Diagonal);
  }
  this->Window.touch(ViewerWindow::Before);
}

bool Viewer::pick(const Pointer& pointer, PickedPlace& place)
{
  const Layout& layout = this->Window.layout();
  const bool before = layout.before.has(pointer.x, pointer.y);
  return (before || layout.after.has(pointer.x, pointer.y)) &&
    this->Picker->pick(this->Window.renderer(before ? ViewerWindow::Before : ViewerWindow::After),
      pointer.x, pointer.y, place);
}

void Viewer::useTool(const PickedPlace& place, const Pointer& pointer)
{
  if (this->View.tool == Tool::Point)
  {
    this->togglePoint(place);
  }
  else if (this->View.tool == Tool::Edge)
  {
    this->tagEdges(place, pointer.shift);
  }
  else if (this->View.tool == Tool::Brush)
  {
    this->Painting = true;
    this->View.brushErases = pointer.control;
    this->View.brushSmooths = pointer.shift && !pointer.control;
    this->LastPainted = pointer;
    this->paint({ place.position }, true);
  }
}

void Viewer::paintTo(const Pointer& pointer)
{
  std::vector<Vec3> way;
  for (const Pointer& there : wayOf(this->LastPainted, pointer))
  {
    PickedPlace place;
    if (this->pick(there, place))
    {
      way.push_back(place.position);
    }
  }
  this->LastPainted = pointer;
  this->paint(way, false);
}

void Viewer::paint(const std::vector<Vec3>& way, bool begins)
{
  const double radius = 0.01 * this->View.brushRadius * this->Diagonal;
  std::vector<Vec3> dabs;
  for (const Vec3& position : way)
  {
    const bool isFirst = begins && dabs.empty();
    if (isFirst || (position - this->LastDab).norm() >= DabDistance * radius)
    {
      this->LastDab = position;
      dabs.push_back(position);
    }
  }
  if (dabs.empty())
  {
    return;
  }
  if (this->View.brushSmooths)
  {
    this->edit(
      [&](Session& s) {
        for (const Vec3& place : this->mirrored(dabs))
        {
          spreadStrokes(s, place, radius, 0.01 * LargestBrush * this->Diagonal);
        }
      },
      false);
    return;
  }
  this->addStrokes(dabs, radius, this->View.brushErases ? 0 : this->View.brushStrength, false);
}

std::vector<Vec3> Viewer::mirrored(const std::vector<Vec3>& positions) const
{
  const int axis = this->View.brushMirror;
  std::vector<Vec3> places;
  for (Vec3 place : positions)
  {
    places.push_back(place);
    if (axis >= 0)
    {
      place[axis] = 2 * this->Input->GetCenter()[axis] - place[axis];
      places.push_back(place);
    }
  }
  return places;
}

void Viewer::addStrokes(
  const std::vector<Vec3>& positions, double radius, double strength, bool rests)
{
  this->edit(
    [&](Session& s) {
      auto strokes = s.list("strokes");
      for (const Vec3& place : this->mirrored(positions))
      {
        strokes.insert(strokes.end(), { place[0], place[1], place[2], radius, strength });
      }
      s.setList("strokes", std::move(strokes));
    },
    rests);
}

void Viewer::fillRegion(bool erases)
{
  PickedPlace place;
  if (!this->pick(this->LastPointer, place))
  {
    this->say("Under the pointer is no region to fill.");
    return;
  }
  this->addStrokes({ place.position }, 0, erases ? 0 : this->View.brushStrength, true);
  if (this->HasAtlas && !this->BeforeSide.hasFeatures())
  {
    this->say("There are no features to stop at: all that hangs together here.");
  }
}

void Viewer::togglePoint(const PickedPlace& place)
{
  const double near = NearPoint * this->Diagonal;
  this->edit(
    [&](Session& s) {
      auto constraints = s.rows<3>("constraints");
      const auto old = std::find_if(constraints.begin(), constraints.end(),
        [&](const auto& p) { return (Vec3(p.data()) - place.position).norm() < near; });
      if (old != constraints.end())
      {
        constraints.erase(old);
      }
      else
      {
        constraints.push_back({ place.position[0], place.position[1], place.position[2] });
      }
      s.setRows("constraints", constraints);
    },
    true);
}

std::vector<std::array<vtkIdType, 2>> Viewer::edgesAt(const PickedPlace& place, bool path) const
{
  if (path && this->LastTagged >= 0)
  {
    return this->Picker->shortestPath(this->LastTagged, place.point);
  }
  return { place.edge };
}

void Viewer::tagEdges(const PickedPlace& place, bool path)
{
  const std::vector<std::array<vtkIdType, 2>> edges = this->edgesAt(place, path);
  this->LastTagged = place.point;
  this->edit(
    [&](Session& s) {
      auto tags = s.rows<2>("feature_edges");
      for (const auto& edge : edges)
      {
        const std::array<double, 2> tag = { static_cast<double>(edge[0]),
          static_cast<double>(edge[1]) };
        const auto old = std::find(tags.begin(), tags.end(), tag);
        if (old == tags.end())
        {
          tags.push_back(tag);
        }
        else if (!path)
        {
          tags.erase(old);
        }
      }
      s.setRows("feature_edges", tags);
    },
    true);
  const auto strokes = this->Now.rows<5>("strokes");
  if (std::any_of(strokes.begin(), strokes.end(), [](const auto& s) { return s[3] <= 0; }))
  {
    this->say("What is filled with paint ends at tagged edges, too.");
  }
}
}
