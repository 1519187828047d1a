// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The column of controls on the right.
#ifndef stipple_Panel_h
#define stipple_Panel_h

#include "Choice.h"
#include "Commands.h"
#include "NumberField.h"
#include "Slider.h"
#include "ViewOptions.h"

#include <memory>
#include <string>
#include <vector>

namespace stipple
{
class Panel
{
public:
  /// What of the input can be chosen at all.
  struct Choosable
  {
    bool arrays = false; ///< of numbers, one a point or cell
    bool regions = false;
    bool selections = false; ///< cell arrays of numbers
    bool textures = false;
  };
  /// `model` is shown.
  Panel(Commands& commands, std::string model, const Choosable& choosable);

  void setBox(const Rect& box, float scale);
  /// Moves what does not fit into the box by notches of the wheel; true if it looks different then.
  bool scroll(int notches);
  /// `points` is how many there are where they follow; 0: not known yet. `edge` is the length that
  /// the mesh's number of points stands for; 0: there is no mesh of this session.
  void show(const Session& session, const ViewState& view, int points, double edge);
  void setUndo(bool canUndo, bool canRedo);
  /// What looks as before is left, unless the canvas is empty. In two halves: VTK's painter keeps
  /// 50 words, and makes each anew in every frame if there are more.
  void paint(Canvas& canvas, bool upper);
  /// Those that are seen.
  std::vector<Control*> controls();
  NumberField& points() { return *this->Number; }

private:
  struct Row
  {
    std::vector<Control*> controls; ///< side by side; none: a heading
    std::string heading;
    float height;
    float space; ///< below
  };
  template <typename T, typename... Arguments>
  T* make(Arguments&&... arguments)
  {
    this->Owned.push_back(std::make_unique<T>(std::forward<Arguments>(arguments)...));
    return static_cast<T*>(this->Owned.back().get());
  }
  void place();
  bool isSeen(const Rect& box) const;
  void addSampling(Commands& commands);
  void addFeatures(Commands& commands);
  void addPointer(Commands& commands);
  void addShow(Commands& commands);
  void addCommands(Commands& commands);
  void addMesh(Commands& commands);
  void addSizes(Commands& commands);
  void addInputs(Commands& commands);
  Choice* optionChoice(Commands& commands, const char* option, std::vector<std::string> words);
  NumberField* optionField(Commands& commands, const char* option, const char* label);
  Choice* arrayChoice(Commands& commands, const char* option, const char* label);
  bool isThere(const std::string& option) const; ///< an array for it
  void showOptions(const Session& session);
  void heading(const std::string& text);
  void row(std::vector<Control*> controls, float height, float space = 4);

  std::string Model;
  Choosable Input;
  Rect Box;
  float Scale = 1;
  float Scrolled = 0; ///< pixels that the rows are moved up
  float Hidden = 0;   ///< pixels of the rows that the box is too low for
  std::vector<std::unique_ptr<Control>> Owned;
  Painted Shown;
  std::vector<Row> Rows;
  std::vector<std::pair<Rect, std::string>> Headings;

  int Points = 0;            ///< that are shown
  int Fixed = DefaultPoints; ///< the last that did not follow from anything
  bool HasPicture = false;
  NumberField* Number = nullptr;
  Slider* PointsSlider = nullptr;
  Choice* Importance = nullptr;
  Slider* Gamma = nullptr;
  Slider* Gradation = nullptr;
  Slider* Floor = nullptr;
  Slider* Angle = nullptr;
  Slider* Charts = nullptr;
  Choice* Tools = nullptr;
  Slider* Radius = nullptr;
  Slider* Strength = nullptr;
  Choice* Clearing = nullptr;
  Choice* Displays = nullptr;
  Choice* Overlays = nullptr;
  Choice* Undoing = nullptr;
  Choice* Coloring = nullptr;
  NumberField* EdgeLength = nullptr;
  Choice* Picture = nullptr;
  Choice* Projection = nullptr;
  Slider* Finest = nullptr;
  Slider* Coarsest = nullptr;

  // By options:
  struct ArrayChoice
  {
    std::string option;
    std::string label;
    std::string hint;
    Choice* choice;
  };
  std::vector<std::pair<std::string, Choice*>> OptionChoices;
  Choice* TextureSeams = nullptr;
  std::vector<std::pair<std::string, NumberField*>> OptionFields;
  std::vector<ArrayChoice> ArrayChoices;
};
}

#endif
