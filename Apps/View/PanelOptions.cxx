// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Controls of options as the table has them: their ranges, defaults and words.
#include "Panel.h"

#include "SessionEdits.h"
#include "Text.h"
#include "TextNumbers.h"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace stipple
{
namespace
{
constexpr float FieldHeight = 25;

/// What the table says, as a sentence.
std::string hintOf(const Option& option)
{
  std::string hint = option.help;
  hint[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(hint[0])));
  return hint + (option.unit.empty() ? "" : " (" + option.unit + ")") + ".";
}

/// Whether the mesh that the session asks for depends on the option.
bool counts(const Option& option, const Session& session)
{
  const std::string& pattern = session.text("pattern");
  if (option.name == "subdivisions")
  {
    return pattern == "semiregular";
  }
  return option.stage != "vtkRemeshOptimizer" || option.name == "feature_tolerance" ||
    pattern != "quads";
}

int indexOf(const std::vector<std::string>& words, const std::string& word)
{
  return static_cast<int>(std::find(words.begin(), words.end(), word) - words.begin());
}
}

Choice* Panel::optionChoice(Commands& commands, const char* option, std::vector<std::string> words)
{
  const int columns = static_cast<int>(words.size());
  auto* choice =
    this->make<Choice>(Choice::Kind::One, std::move(words), columns, [&commands, option](int word) {
      commands.edit(
        [option, word](Session& s) { s.set(option, findOption(option)->choices[word]); }, true);
    });
  this->OptionChoices.emplace_back(option, choice);
  return choice;
}

NumberField* Panel::optionField(Commands& commands, const char* option, const char* label)
{
  const Option& o = *findOption(option);
  const std::string name = option;
  auto* field = this->make<NumberField>(label,
    NumberField::Range{ o.low, o.high, o.kind == Option::Kind::Integer, !o.automatic.empty() },
    [this, &commands, name](double value) {
      commands.edit(
        [this, name, value](Session& s) { setNumber(s, name, value, this->Fixed); }, true);
    });
  field->setAutomatic(o.automatic);
  const double usual = Session().number(name);
  field->setDefault(usual);
  const bool isAutomatic = usual == 0 && !o.automatic.empty();
  field->setHint(hintOf(o) + " Right button" +
    (isAutomatic
        ? ", or empty: " + o.automatic
        : ": " + shortestText(usual) + (o.automatic.empty() ? "" : "; empty: " + o.automatic)) +
    ".");
  this->OptionFields.emplace_back(option, field);
  return field;
}

bool Panel::isThere(const std::string& option) const
{
  return option == "region_array" ? this->Input.regions
    : option == "select_array"    ? this->Input.selections
                                  : this->Input.arrays;
}

Choice* Panel::arrayChoice(Commands& commands, const char* option, const char* label)
{
  auto* choice = this->make<Choice>(Choice::Kind::Commands, std::vector<std::string>{ label }, 1,
    [this, &commands, option](int) { commands.chooseArray(option, this->Fixed); });
  const std::string name = option;
  const bool regions = name == "region_array";
  const bool selects = name == "select_array";
  const bool isThere = this->isThere(name);
  choice->setReset([this, &commands, name] {
    commands.edit([this, name](Session& s) { setArray(s, name, "", this->Fixed); }, true);
  });
  const std::string hint = isThere ? hintOf(*findOption(option)) + " Right button: none."
    : regions                      ? "The file has no array of its cells that could tell regions."
    : selects                      ? "The file has no array of its cells that could tell a part."
                                   : "The file has no array of numbers.";
  this->ArrayChoices.push_back({ option, label, hint, choice });
  return choice;
}

void Panel::addMesh(Commands& commands)
{
  auto* preset = this->optionChoice(commands, "preset", { "uniform", "adaptive", "rib" });
  preset->setHints(
    { "Triangles that are alike, whatever the importance.", "Triangles that follow the importance.",
      "They follow the importance, with two neighbours on each side of features." });
  auto* pattern = this->optionChoice(commands, "pattern", { "triangles", "quads", "semi-regular" });
  pattern->setHints({ "A mesh of triangles.",
    "Quads along the axes of every chart, the more the more alike sizes are; not optimised.",
    "Triangles split 1 to 4; the number of points is the base mesh's." });
  auto* smoothing =
    this->optionChoice(commands, "smoothing", { "rough", "area", "density", "Lloyd" });
  smoothing->setHints({ "Points stay where they were sampled.",
    "Points move until the triangles around them are alike.",
    "Points move until as much density is around each.",
    "Points move to the centroids of their Voronoi cells." });
  this->heading("Mesh");
  this->row({ preset }, 27);
  this->row({ pattern }, 27);
  this->row({ smoothing }, 27);
  this->row({ this->optionField(commands, "iterations", "Rounds") }, FieldHeight);
  auto* placement =
    this->optionChoice(commands, "placement", { "on the surface", "nearest to it" });
  placement->setHints({ "Points lie on the surface.",
    "Points leave the surface where triangles fit it best so (least squares)." });
  auto* connectivity =
    this->optionChoice(commands, "connectivity", { "no swaps", "regularity", "aspect" });
  connectivity->setHints({ "Edges stay as the triangulation has them.",
    "Edges are swapped until most points have six neighbours.",
    "Edges are swapped until triangles are fat." });
  this->row({ placement }, FieldHeight);
  this->row({ connectivity }, FieldHeight);
  this->row(
    { this->optionField(commands, "subdivisions", "Levels, semi-regular") }, FieldHeight, 14);
}

void Panel::addSizes(Commands& commands)
{
  this->heading("Sizes");
  this->EdgeLength = this->optionField(commands, "edge_length", "Edge length");
  this->row({ this->EdgeLength }, FieldHeight);
  for (const auto& [option, label] :
    { std::pair("max_deviation", "Distance, %"), std::pair("curvature_points", "Points per turn"),
      std::pair("size_minimum", "Shortest edge"), std::pair("size_maximum", "Longest edge"),
      std::pair("growth", "Growth of edges") })
  {
    this->row({ this->optionField(commands, option, label) }, FieldHeight);
  }
  this->row({ this->arrayChoice(commands, "size_array", "lengths from") }, FieldHeight, 14);
}

void Panel::addInputs(Commands& commands)
{
  this->heading("Regions, arrays and pictures");
  this->TextureSeams = this->make<Choice>(
    Choice::Kind::Several, std::vector<std::string>{ "UV seams" }, 1, [&commands](int) {
      commands.edit(
        [](Session& s) { s.set("keep_uv_seams", s.flag("keep_uv_seams") ? 0. : 1.); }, true);
    });
  this->TextureSeams->setHints({ this->Input.textures ? hintOf(*findOption("keep_uv_seams"))
                                                      : "The file has no texture coordinates." });
  this->row(
    { this->arrayChoice(commands, "region_array", "regions"), this->TextureSeams }, FieldHeight);
  this->row({ this->arrayChoice(commands, "select_array", "only the part") }, FieldHeight);
  this->row({ this->arrayChoice(commands, "importance_array", "importance from") }, FieldHeight);
  this->Picture = this->make<Choice>(Choice::Kind::Commands, std::vector<std::string>{ "" }, 1,
    [&commands](int) { commands.choosePicture(); });
  this->Picture->setReset([&commands] { commands.edit(removePicture, true); });
  this->Projection =
    this->optionChoice(commands, "image_projection", { "pasted", "along x", "along y", "along z" });
  this->row({ this->Picture }, FieldHeight);
  this->row({ this->Projection }, FieldHeight, 8);
  const auto band = [this, &commands](const char* label, int end) {
    auto* slider = this->make<Slider>(
      label, Slider::Range{ 0, 20, 2, false, 0.05 },
      [](double value) {
        return value > 0 ? shortestText(std::round(100. * value) / 100.) + " %"
                         : std::string("all");
      },
      [&commands, end](double value, bool rests) {
        commands.edit([end, value](Session& s) { setBand(s, end, value); }, rests);
      });
    slider->setDefault(0);
    slider->setHint(end == 0
        ? "Of the importance, no detail finer than this, % of the diagonal; after \"coarsest\"."
        : "Of the importance, no detail coarser than this, % of the diagonal.");
    return slider;
  };
  this->Coarsest = band("Coarsest", 1);
  this->Finest = band("Finest", 0);
  this->row({ this->Finest, this->Coarsest }, 34, 8);
}

void Panel::showOptions(const Session& s)
{
  const std::string why = whyImportanceRests(s);
  const bool importanceCounts = why.empty();
  const auto unlessItRests = [&why](const std::string& hint) {
    return why.empty() ? hint : "Left out while " + why + ".";
  };
  for (const auto& [option, choice] : this->OptionChoices)
  {
    choice->choose(indexOf(findOption(option)->choices, s.text(option)));
    for (std::size_t word = 0; word < findOption(option)->choices.size(); ++word)
    {
      // A part is remeshed with triangles only.
      const bool excluded =
        option == std::string("pattern") && word > 0 && !s.text("select_array").empty();
      choice->setEnabled(static_cast<int>(word), counts(*findOption(option), s) && !excluded);
    }
  }
  for (const auto& [option, field] : this->OptionFields)
  {
    field->setValue(s.number(option));
    field->setEnabled(counts(*findOption(option), s));
  }
  for (const auto& [option, label, hint, choice] : this->ArrayChoices)
  {
    const std::string& array = s.text(option);
    choice->setWord(0, label + ": " + (array.empty() ? "none" : array));
    choice->setOn(0, !array.empty());
    const bool isImportance = option == "importance_array";
    choice->setEnabled(0, this->isThere(option) && (importanceCounts || !isImportance));
    choice->setHints({ isImportance ? unlessItRests(hint) : hint });
  }
  this->TextureSeams->setOn(0, s.flag("keep_uv_seams"));
  this->TextureSeams->setEnabled(0, this->Input.textures || s.flag("keep_uv_seams"));
  const std::string& picture = s.text("importance_image");
  this->Picture->setWord(0, "picture: " + (picture.empty() ? "none" : nameOfFile(picture)));
  this->Picture->setOn(0, s.text("importance") == "image");
  this->Picture->setEnabled(0, importanceCounts);
  this->Picture->setHints({ unlessItRests(
    "A picture whose bright places attract samples: .png, .jpg, ... Right button: none.") });
  for (int word = 0; word < 4; ++word)
  {
    this->Projection->setEnabled(word, importanceCounts && !picture.empty());
  }
  const std::string none = "There is no picture yet: choose one above.";
  this->Projection->setHints(picture.empty()
      ? std::vector<std::string>(4, none)
      : std::vector<std::string>{ "The picture lies in every chart.", "It is projected along x.",
          "It is projected along y.", "It is projected along z." });
  this->Finest->setValue(s.list("band_pass")[0]);
  this->Finest->setEnabled(importanceCounts && s.list("band_pass")[1] > 0);
  this->Coarsest->setValue(s.list("band_pass")[1]);
  this->Coarsest->setEnabled(importanceCounts);
}
}
