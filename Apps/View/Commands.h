// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What the controls and keys can ask for.
#ifndef stipple_Commands_h
#define stipple_Commands_h

#include "Session.h"
#include "ViewState.h"

#include <functional>
#include <string>

namespace stipple
{
class Commands
{
public:
  enum class Clear
  {
    Paint,
    Points,
    Edges
  };
  virtual ~Commands() = default;

  /// Changes the session. The mesh follows once `rests`; all changes until then are one for undo.
  virtual void edit(const std::function<void(Session&)>& change, bool rests) = 0;
  virtual void changeView(const std::function<void(ViewState&)>& change) = 0;
  virtual void clear(Clear what) = 0;
  virtual void undo() = 0;
  virtual void redo() = 0;
  virtual void saveMesh() = 0;
  virtual void savePicture() = 0;
  virtual void saveSession() = 0;
  virtual void openFile() = 0;
  virtual void saveMeshAs() = 0;
  virtual void saveFigures() = 0;
  /// Asks which of the input's arrays an option is to name; `points`: see setArray().
  virtual void chooseArray(const std::string& option, int points) = 0;
  virtual void choosePicture() = 0;
  /// In the status line; `alarm`: it went wrong.
  virtual void say(const std::string& sentence, bool alarm) = 0;
};
}

#endif
