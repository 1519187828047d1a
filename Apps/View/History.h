// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef stipple_History_h
#define stipple_History_h

#include "Session.h"

#include <vector>

namespace stipple
{
/// Undo and redo of whole sessions: they are small.
class History
{
public:
  /// `before` is what undo() goes back to.
  void add(const Session& before)
  {
    this->Past.push_back(before);
    this->Future.clear();
  }
  [[nodiscard]] bool canUndo() const { return !this->Past.empty(); }
  [[nodiscard]] bool canRedo() const { return !this->Future.empty(); }
  void undo(Session& now) { move(this->Past, this->Future, now); }
  void redo(Session& now) { move(this->Future, this->Past, now); }

private:
  static void move(std::vector<Session>& from, std::vector<Session>& to, Session& now)
  {
    if (!from.empty())
    {
      to.push_back(now);
      now = from.back();
      from.pop_back();
    }
  }
  std::vector<Session> Past;
  std::vector<Session> Future;
};
}

#endif
