// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The command line of stipple-view.
#ifndef stipple_ViewOptions_h
#define stipple_ViewOptions_h

#include "Progress.h"

#include <string>
#include <vector>

namespace stipple
{
/// The number of points that the window takes: with more, a preview takes seconds.
constexpr int MostPoints = 1'000'000;

struct ViewOptions
{
  /// Something to do after the window opened; in the order of the command line.
  struct Step
  {
    enum class Kind
    {
      Play, ///< recorded events
      Shot  ///< a picture of the window, once it has settled
    };
    Kind kind;
    std::string file;
  };

  std::string input;   ///< empty: the session's model
  std::string session; ///< file to begin with
  int points = 0;      ///< 0: the session's, or 5000
  int width = 1280;
  int height = 800;
  std::string output;      ///< where "save mesh" writes
  std::string picture;     ///< where "picture" writes
  std::string saveSession; ///< where "session" writes
  std::string record;      ///< file for what is done in the window
  std::vector<Step> steps; ///< if there are some, the program ends after them
  std::string benchmark;   ///< file of figures; the program ends with them

  bool help = false;
  bool version = false;
};

/// An error is the one sentence for stderr.
[[nodiscard]] Status parseViewOptions(
  const std::vector<std::string>& arguments, ViewOptions& options);

[[nodiscard]] std::string viewHelpText();
}

#endif
