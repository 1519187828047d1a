// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Panel.h"

#include "Document.h"
#include "MessageText.h"
#include "SceneActors.h"
#include "SessionEdits.h"
#include "ViewOptions.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace stipple
{
namespace
{
constexpr const char* SliderHint = "Click its number to type; right button: default.";
// Pixels at scale 1.
constexpr float HeaderHeight = 54; ///< above the first row
constexpr float HeadRule = 38;     ///< of the line below the name
constexpr float BottomPad = 8;
constexpr float ScrollStep = 60; ///< a notch of the wheel
constexpr int ArrayWord = 7;     // of the importances

/// Of the buttons of the importance.
std::vector<std::string> importanceHints()
{
  return { "The same density everywhere.", "More samples where the mean curvature is large.",
    "More samples where the Gaussian curvature is large.",
    "More samples where the smaller principal curvature is large.",
    "More samples where the larger principal curvature is large.",
    "More samples where the surface bends: both principal curvatures, squared and added.",
    "The density that approximates the surface best (L2): fewest points for an error.",
    "The density is that of a picture, or of an array of the file that is chosen." };
}

Slider::Format format(const char* pattern)
{
  return [pattern](double value) {
    char text[48];
    std::snprintf(text, sizeof(text), pattern, value);
    return std::string(text);
  };
}
}

Panel::Panel(Commands& commands, std::string model, const Choosable& choosable)
  : Model(std::move(model))
  , Input(choosable)
{
  this->addSampling(commands);
  this->addFeatures(commands);
  this->addPointer(commands);
  this->addShow(commands);
  this->addCommands(commands);
  this->addMesh(commands);
  this->addSizes(commands);
  this->addInputs(commands);
  for (const auto& control : this->Owned)
  {
    control->setTell([&commands](const std::string& sentence) { commands.say(sentence, false); });
  }
}

void Panel::heading(const std::string& text)
{
  this->Rows.push_back({ {}, text, 18, 2 });
}

void Panel::row(std::vector<Control*> controls, float height, float space)
{
  this->Rows.push_back({ std::move(controls), "", height, space });
}

void Panel::addSampling(Commands& commands)
{
  this->Number =
    this->make<NumberField>("", NumberField::Range{ 1, MostPoints }, [&commands](double points) {
      commands.edit([points](Session& s) { setPoints(s, points); }, true);
    });
  Slider::Range range{ 100, MostSliderPoints };
  range.logarithmic = true;
  this->PointsSlider = this->make<Slider>(
    "", range, [](double) { return std::string(); },
    [this, &commands](double value, bool rests) {
      const int points = static_cast<int>(twoDigits(value));
      // A press that moves nothing keeps a number that was typed.
      commands.edit(
        [this, points, value](Session& s) {
          if (std::abs(value - this->Points) >= 1)
          {
            setPoints(s, points);
          }
        },
        rests);
    });
  this->Importance = this->make<Choice>(Choice::Kind::One,
    std::vector<std::string>{ "uniform", "mean", "Gauss", "min", "max", "total", "L2", "array" }, 4,
    [this, &commands](int word) {
      if (word == ArrayWord && this->HasPicture)
      {
        commands.edit([](Session& s) { s.set("importance", "image"); }, true);
      }
      else if (word == ArrayWord)
      {
        commands.chooseArray("importance_array", this->Fixed);
      }
      else
      {
        commands.edit(
          [word](Session& s) { s.set("importance", findOption("importance")->choices[word]); },
          true);
      }
    });
  this->Gamma = this->make<Slider>("Gamma", Slider::Range{ 0, 3, 1, false, 0.01 }, format("%.2f"),
    [&commands](double value, bool rests) {
      commands.edit([value](Session& s) { s.set("gamma", value); }, rests);
    });
  this->Gradation = this->make<Slider>("Gradation", Slider::Range{ 0, 10, 2, false, 0.05 },
    format("%.2f %%"), [&commands](double value, bool rests) {
      commands.edit([value](Session& s) { s.set("gradation", value); }, rests);
    });
  this->Floor = this->make<Slider>("Least density", Slider::Range{ 0, 1, 2, false, 0.005 },
    format("%.3f"), [&commands](double value, bool rests) {
      commands.edit([value](Session& s) { s.set("minimum_density", value); }, rests);
    });
  const Session defaults = openingSession();
  this->Gamma->setDefault(defaults.number("gamma"));
  this->Gradation->setDefault(defaults.number("gradation"));
  this->Floor->setDefault(defaults.number("minimum_density"));
  this->PointsSlider->setDefault(DefaultPoints);
  this->Gamma->setHint("The importance to this power: 0 uniform, 1 as it is, more sharpens. " +
    std::string(SliderHint));
  this->Gradation->setHint(
    "How smoothly sizes change: a Gaussian's width, % of the diagonal. " + std::string(SliderHint));
  this->Floor->setHint(
    "What is not important has so much of the highest density. " + std::string(SliderHint));
  this->row({ this->Number }, 27, 2);
  this->row({ this->PointsSlider }, 20, 12);
  this->heading("Importance");
  this->row({ this->Importance }, 54, 8);
  this->row({ this->Gamma }, 34);
  this->row({ this->Gradation }, 34);
  this->row({ this->Floor }, 34, 14);
}

void Panel::addFeatures(Commands& commands)
{
  this->Angle = this->make<Slider>(
    "Feature angle", Slider::Range{ 0, 180, 1, false, 1 },
    [](double value) { return value >= 180 ? std::string("none") : format("%.0f\u00b0")(value); },
    [&commands](double value, bool rests) {
      commands.edit([value](Session& s) { s.set("feature_angle", value); }, rests);
    });
  Slider::Range range{ 1, 200 };
  range.logarithmic = true;
  range.step = 1;
  this->Charts = this->make<Slider>(
    "Charts, at least", range, format("%.0f"), [&commands](double value, bool rests) {
      commands.edit([value](Session& s) { s.set("charts", std::trunc(value)); }, rests);
    });
  const Session defaults = openingSession();
  this->Angle->setDefault(defaults.number("feature_angle"));
  this->Charts->setDefault(defaults.number("charts"));
  this->Angle->setHint(
    "Edges bent more than this are features (red), kept in the mesh. " + std::string(SliderHint));
  this->Charts->setHint(
    "The surface is cut into so many pieces at least. " + std::string(SliderHint));
  this->heading("Features and charts");
  this->row({ this->Angle }, 34);
  this->row({ this->Charts }, 34, 14);
}

void Panel::addPointer(Commands& commands)
{
  this->Tools = this->make<Choice>(Choice::Kind::One,
    std::vector<std::string>{ "camera", "brush", "point", "edge" }, 4, [&commands](int word) {
      commands.changeView([word](ViewState& v) { v.tool = static_cast<Tool>(word); });
    });
  this->Radius =
    this->make<Slider>("Brush", Slider::Range{ LeastBrush, LargestBrush, 2, false, 0.5 },
      format("%.1f %%"), [&commands](double value, bool) {
        commands.changeView([value](ViewState& v) { v.brushRadius = value; });
      });
  this->Strength = this->make<Slider>(
    "Paint", Slider::Range{ -1, 3, 1, false, 0.1 },
    [](double value) {
      return value > 0 ? format("+%.1f")(value)
        : value < 0    ? format("erase %.0f %%")(-100 * value)
                       : std::string("none");
    },
    [&commands](double value, bool) {
      commands.changeView([value](ViewState& v) { v.brushStrength = value; });
    });
  this->Clearing = this->make<Choice>(Choice::Kind::Commands,
    std::vector<std::string>{ "clear paint", "clear points", "clear edges" }, 3,
    [&commands](int word) { commands.clear(static_cast<Commands::Clear>(word)); });
  const ViewState defaults;
  this->Radius->setDefault(defaults.brushRadius);
  this->Strength->setDefault(defaults.brushStrength);
  this->Tools->setHints({ "v: turn, move, zoom.", "b: paint density on either model or the map.",
    "k: pick points that must be vertices.", "x: tag edges as features." });
  this->Radius->setHint(
    "The brush's radius, % of the diagonal; [ and ]. " + std::string(SliderHint));
  this->Strength->setHint(
    "What a dab adds; below 0 the share of all importance that it takes away, at 0 paint alone. " +
    std::string(SliderHint));
  this->heading("Pointer");
  this->row({ this->Tools }, 27, 6);
  this->row({ this->Radius, this->Strength }, 34, 6);
  this->row({ this->Clearing }, 27, 10);
}

void Panel::addShow(Commands& commands)
{
  this->Displays = this->make<Choice>(Choice::Kind::One,
    std::vector<std::string>{ "samples", "input", "charts", "density" }, 4, [&commands](int word) {
      commands.changeView([word](ViewState& v) { v.show(static_cast<Display>(word)); });
    });
  this->Overlays = this->make<Choice>(Choice::Kind::Several,
    std::vector<std::string>{ "feature lines", "seams", "one view" }, 3, [&commands](int word) {
      commands.changeView([word](ViewState& v) {
        bool& on = word == 0 ? v.features : (word == 1 ? v.seams : v.oneView);
        on = !on;
      });
    });
  this->Displays->setHints(
    { "d: samples; once the mesh is there, its vertices.", "d: the surface with its edges.",
      "d: the pieces that it is cut into.", "d: how many samples are wanted where." });
  this->Overlays->setHints({ "l: features red, boundaries blue; violet: simplified in the mesh.",
    "m: where the surface is cut, dark.",
    "o: both models in one place; drag the line between them." });
  this->Coloring = this->make<Choice>(Choice::Kind::One,
    std::vector<std::string>{ "plain", "angle", "quality", "distance" }, 4, [&commands](int word) {
      commands.changeView([word](ViewState& v) { v.colorBy(static_cast<MeshColoring>(word)); });
    });
  this->Coloring->setHints(
    { "c: the mesh in one color.", "c: triangles by their smallest angle; g goes to the worst.",
      "c: triangles by quality, 1 where they are equilateral.",
      "c: triangles by their distance from the input; with \"input\" above, that from the mesh, "
      "too." });
  this->heading("Show");
  this->row({ this->Displays }, 25);
  this->row({ this->Overlays }, 25, 6);
  this->heading("Mesh colored by");
  this->row({ this->Coloring }, 25, 10);
}

void Panel::addCommands(Commands& commands)
{
  this->Undoing = this->make<Choice>(Choice::Kind::Commands,
    std::vector<std::string>{ "undo", "redo", "help" }, 3, [&commands](int word) {
      if (word == 2)
      {
        commands.changeView([](ViewState& v) { v.help = !v.help; });
        return;
      }
      word == 0 ? commands.undo() : commands.redo();
    });
  auto* saving = this->make<Choice>(Choice::Kind::Commands,
    std::vector<std::string>{ "save mesh", "picture", "session" }, 3, [&commands](int word) {
      word == 0 ? commands.saveMesh()
                : (word == 1 ? commands.savePicture() : commands.saveSession());
    });
  this->Undoing->setHints({ "Ctrl+Z", "Ctrl+Y", "h: all keys." });
  saving->setHints({ "Ctrl+S: the mesh, in its file.", "Ctrl+P: a picture of the window.",
    "Ctrl+J: everything that makes this mesh again." });
  this->row({ this->Undoing }, 25, 3);
  this->row({ saving }, 25, 3);
  auto* files = this->make<Choice>(Choice::Kind::Commands,
    std::vector<std::string>{ "open", "save as", "figures" }, 3, [&commands](int word) {
      word == 0 ? commands.openFile()
                : (word == 1 ? commands.saveMeshAs() : commands.saveFigures());
    });
  files->setHints({ "Ctrl+O: another surface, or a session; or drop one.",
    "Ctrl+Shift+S: the mesh, or the session (.json), under a name.",
    "Ctrl+E: both views alone, 2000 pixels high, transparent." });
  this->row({ files }, 25, 14);
}

void Panel::setBox(const Rect& box, float scale)
{
  this->Box = box;
  this->Scale = scale;
  float height = 0;
  for (const Row& row : this->Rows)
  {
    height += (row.height + row.space) * scale;
  }
  this->Hidden = std::max(0.F, height - (box.h - (HeaderHeight + BottomPad) * scale));
  this->place();
}

bool Panel::scroll(int notches)
{
  const float before = this->Scrolled;
  this->Scrolled -= static_cast<float>(notches) * ScrollStep * this->Scale;
  this->place();
  return this->Scrolled != before;
}

bool Panel::isSeen(const Rect& box) const
{
  // A half seen control would lie over the panel's head.
  return box.top() <= this->Box.top() - HeadRule * this->Scale && box.y >= this->Box.y;
}

void Panel::place()
{
  const Rect& box = this->Box;
  const float scale = this->Scale;
  this->Scrolled = std::clamp(this->Scrolled, 0.F, this->Hidden);
  this->Headings.clear();
  const Rect inner = { box.x + 14 * scale, box.y, box.w - 28 * scale, box.h };
  float y = box.top() - HeaderHeight * scale + this->Scrolled;
  for (const Row& row : this->Rows)
  {
    y -= row.height * scale;
    const Rect place{ inner.x, y, inner.w, row.height * scale };
    if (row.controls.empty())
    {
      this->Headings.emplace_back(place, row.heading);
    }
    const float gap = 14 * scale;
    const auto count = static_cast<float>(row.controls.size());
    const float width = (place.w - gap * (count - 1)) / std::max(1.F, count);
    for (std::size_t i = 0; i < row.controls.size(); ++i)
    {
      row.controls[i]->setBox(
        { place.x + static_cast<float>(i) * (width + gap), y, width, place.h });
    }
    y -= row.space * scale;
  }
}

void Panel::show(const Session& s, const ViewState& v, int points, double edge)
{
  const bool follows = pointsFollow(s) || s.number("max_deviation") > 0;
  this->Points = follows && points > 0 ? points : s.integer("points");
  this->Fixed = s.integer("points") > 0 ? s.integer("points") : this->Fixed;
  const bool part = !s.text("select_array").empty();
  const bool isBase = s.text("pattern") == "semiregular";
  this->Number->setLabel(follows ? "Points that follow"
      : part                     ? "Points of the part"
      : isBase                   ? "Points of the base"
                                 : "Number of points");
  const std::string hint = part ? "So many new points has the part, besides those on its border."
    : isBase ? "So many points has the base mesh; each level has about four times as many."
             : "The mesh has exactly so many points.";
  this->Number->setOld(follows && edge == 0);
  this->Number->setHint(hint + " Click or n, digits, Return.");
  this->PointsSlider->setHint(hint);
  this->Number->setValue(this->Points);
  Slider::Range range{ 100, std::max<double>(MostSliderPoints, this->Points) };
  range.logarithmic = true;
  this->PointsSlider->setRange(range);
  this->PointsSlider->setValue(this->Points);
  this->showOptions(s);
  this->EdgeLength->setAutomatic(edge > 0 ? "now " + format("%.3g")(edge) : "");
  const std::string& importance = s.text("importance");
  const auto& names = findOption("importance")->choices;
  const auto kind =
    static_cast<int>(std::find(names.begin(), names.end(), importance) - names.begin());
  this->HasPicture = !s.text("importance_image").empty();
  this->Importance->choose(std::min(kind, ArrayWord));
  this->Importance->setWord(ArrayWord,
    importance == "array" ? s.text("importance_array") : (this->HasPicture ? "image" : "array"));
  const std::string why = whyImportanceRests(s);
  const bool counts = why.empty();
  for (int word = 0; word < ArrayWord; ++word)
  {
    this->Importance->setEnabled(word, counts);
  }
  this->Importance->setEnabled(ArrayWord, counts && (this->HasPicture || this->Input.arrays));
  this->Importance->setHints(counts ? importanceHints()
                                    : std::vector<std::string>(ArrayWord + 1,
                                        "Left out while " + why + ": see Mesh and Sizes below."));
  for (Slider* slider : { this->Gamma, this->Gradation, this->Floor })
  {
    slider->setEnabled(counts && importance != "uniform");
  }
  this->Gamma->setValue(s.number("gamma"));
  this->Gradation->setValue(s.number("gradation"));
  this->Floor->setValue(s.number("minimum_density"));
  this->Angle->setValue(s.number("feature_angle"));
  this->Charts->setValue(s.number("charts"));
  this->Tools->choose(static_cast<int>(v.tool));
  this->Radius->setValue(v.brushRadius);
  this->Strength->setValue(v.brushStrength);
  this->Clearing->setEnabled(0, !s.list("strokes").empty());
  this->Clearing->setEnabled(1, !s.list("constraints").empty());
  this->Clearing->setEnabled(2, !s.list("feature_edges").empty());
  this->Clearing->setHints({ s.list("strokes").empty() ? "Nothing is painted."
                                                       : "Takes all paint away.",
    s.list("constraints").empty() ? "No point is picked." : "Takes all picked points away.",
    s.list("feature_edges").empty() ? "No edge is tagged." : "Takes the tags of all edges away." });
  this->Displays->choose(v.wireframe ? -1 : static_cast<int>(v.display));
  this->Overlays->setOn(0, v.features);
  this->Overlays->setOn(1, v.seams);
  this->Overlays->setOn(2, v.oneView);
  this->Undoing->setOn(2, v.help);
  this->Coloring->choose(v.wireframe ? -1 : static_cast<int>(v.coloring));
}

void Panel::setUndo(bool canUndo, bool canRedo)
{
  this->Undoing->setEnabled(0, canUndo);
  this->Undoing->setEnabled(1, canRedo);
}

void Panel::paint(Canvas& canvas, bool upper)
{
  const float s = canvas.scale();
  const float left = this->Box.x + 14 * s;
  const float right = this->Box.right() - 14 * s;
  const float middle = this->Box.y + 0.45F * this->Box.h;
  if (upper && canvas.empty())
  {
    canvas.fill(this->Box, shades::Ground);
    canvas.rule(this->Box.x + 1, this->Box.y, this->Box.x + 1, this->Box.top(), shades::Line);
    const float y = this->Box.top() - 19 * s;
    canvas.text(left, y, "stipple", { 16, shades::Accent, Align::Left, true });
    const TextLook quiet{ 12, shades::Quiet, Align::Right };
    canvas.text(right, y, canvas.fitted(this->Model, this->Box.w - 110 * s, quiet), quiet);
    const float rule = this->Box.top() - HeadRule * s;
    canvas.rule(left, rule, right, rule, shades::Line);
    if (this->Hidden > 0)
    {
      const float seen = rule - this->Box.y;
      const float length = seen * seen / (seen + this->Hidden);
      const float top = rule - this->Scrolled / this->Hidden * (seen - length);
      canvas.fill({ this->Box.right() - 5 * s, top - length, 3 * s, length }, shades::Faint);
    }
  }
  for (const auto& heading : this->Headings)
  {
    if (canvas.empty() && (heading.first.y > middle) == upper && this->isSeen(heading.first))
    {
      canvas.text(heading.first.x, heading.first.y + 0.5F * heading.first.h, heading.second,
        { 11, shades::Quiet, Align::Left, true });
    }
  }
  for (const auto& control : this->Owned)
  {
    if ((control->box().y > middle) == upper && this->isSeen(control->box()))
    {
      this->Shown.update(
        canvas, control->box().inset(-1), [&control](Canvas& c) { control->paint(c); });
    }
  }
}

std::vector<Control*> Panel::controls()
{
  std::vector<Control*> list;
  for (const auto& control : this->Owned)
  {
    if (this->isSeen(control->box()))
    {
      list.push_back(control.get());
    }
  }
  return list;
}
}
