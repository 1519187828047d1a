// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Something in the window that is looked at and, mostly, handled: a slider, a button, a curve.
#ifndef stipple_Control_h
#define stipple_Control_h

#include "Canvas.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace stipple
{
/// Where the pointer is, in window pixels, and what is held down with it.
struct Pointer
{
  float x = 0;
  float y = 0;
  bool shift = false;
  bool control = false;
  bool secondary = false; ///< the right button
};

/// The pointer's way from one place to the next at which it was seen, in steps of two pixels,
/// without the first place: a quick hand is seen in few.
inline std::vector<Pointer> wayOf(const Pointer& from, const Pointer& to)
{
  constexpr float Step = 2;
  const float x = to.x - from.x;
  const float y = to.y - from.y;
  const int steps = std::max(1, static_cast<int>(std::hypot(x, y) / Step));
  std::vector<Pointer> way(static_cast<std::size_t>(steps), to);
  for (int i = 1; i < steps; ++i)
  {
    const float share = static_cast<float>(i) / static_cast<float>(steps);
    way[static_cast<std::size_t>(i - 1)].x = from.x + share * x;
    way[static_cast<std::size_t>(i - 1)].y = from.y + share * y;
  }
  return way;
}

struct KeyStroke
{
  std::string symbol; ///< X11's name: "a", "Return", "Escape", ...
  char letter = 0;    ///< what it types, 0 if nothing
  bool shift = false;
  bool control = false;
};

/// What people call a key.
inline std::string nameOfKey(const std::string& symbol)
{
  return symbol == "Return" ? "Enter" : (symbol == "Escape" ? "Esc" : symbol);
}

class Control
{
public:
  explicit Control(const Rect& box = {})
    : Box(box)
  {
  }
  virtual ~Control() = default;
  Control(const Control&) = delete;
  Control& operator=(const Control&) = delete;

  const Rect& box() const { return this->Box; }
  virtual void setBox(const Rect& box) { this->Box = box; }

  virtual void paint(Canvas& canvas) = 0;

  /// A button went down within the box. True: it is for this control, which gets drag() and
  /// release() then.
  virtual bool press(const Pointer&) { return false; }
  virtual void drag(const Pointer&) {}
  virtual void release(const Pointer&) {}

  /// The pointer is over it, or no more. True if it looks different then.
  virtual bool hover(bool over, const Pointer&)
  {
    const bool changed = this->Hovered != over;
    this->Hovered = over;
    return changed && this->isHandled();
  }

  /// What it is for, where the pointer is over it: a sentence, or nothing.
  virtual std::string hint(const Pointer&) const { return this->Hint; }
  void setHint(const std::string& hint) { this->Hint = hint; }

  /// Whether keys go to it, after it was pressed; blur() when something else was.
  virtual bool wantsKeys() const { return false; }
  virtual bool key(const KeyStroke&) { return false; }
  virtual void blur() {}

  /// Where it says what it does not show.
  using Tell = std::function<void(const std::string&)>;
  void setTell(const Tell& tell) { this->OnTell = tell; }

protected:
  virtual bool isHandled() const { return true; }
  void tell(const std::string& sentence) const
  {
    if (this->OnTell)
    {
      this->OnTell(sentence);
    }
  }
  Rect Box;
  std::string Hint;
  bool Hovered = false;

private:
  Tell OnTell;
};
}

#endif
