// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What the window's controls draw with: a few shapes and words in the program's colours, on VTK's
// 2D painter. Places are window pixels, y up.
#ifndef stipple_Canvas_h
#define stipple_Canvas_h

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

class vtkContext2D;
class vtkImageData;

namespace stipple
{
struct Rect
{
  float x = 0;
  float y = 0; ///< of the lower side
  float w = 0;
  float h = 0;

  float right() const { return this->x + this->w; }
  float top() const { return this->y + this->h; }
  bool has(float px, float py) const
  {
    return px >= this->x && px < this->right() && py >= this->y && py < this->top();
  }
  /// Smaller by d on each side; larger where d is negative.
  Rect inset(float d) const
  {
    return { this->x + d, this->y + d, this->w - 2 * d, this->h - 2 * d };
  }
};

struct Shade
{
  unsigned char r = 0;
  unsigned char g = 0;
  unsigned char b = 0;
  unsigned char a = 255;
};

/// The window's colours.
namespace shades
{
constexpr Shade Ground{ 240, 242, 245 }; ///< of the panels
constexpr Shade Card{ 255, 255, 255 };   ///< of views and fields
constexpr Shade Line{ 208, 213, 220 };   ///< between things
constexpr Shade Word{ 41, 46, 54 };      ///< text
constexpr Shade Quiet{ 96, 104, 116 };   ///< text of less weight
constexpr Shade Faint{ 160, 167, 177 };  ///< text of what is not available
constexpr Shade Accent{ 38, 98, 184 };   ///< what is chosen
constexpr Shade AccentSoft{ 217, 229, 246 };
constexpr Shade Hover{ 228, 232, 238 };
constexpr Shade Alarm{ 190, 40, 36 }; ///< what went wrong
}

enum class Align
{
  Left,
  Center,
  Right
};

struct TextLook
{
  float size = 12; ///< pixels at scale 1
  Shade shade = shades::Word;
  Align align = Align::Left;
  bool bold = false;
};

class Canvas
{
public:
  /// `scale` multiplies sizes of letters and widths of lines, not places. `empty`: nothing is left
  /// of what was painted before.
  Canvas(vtkContext2D* painter, float scale, bool empty = true)
    : Painter(painter)
    , Scale(scale)
    , Empty(empty)
  {
  }

  float scale() const { return this->Scale; }
  bool empty() const { return this->Empty; }

  /// A number for what `paint` would paint, without painting it: the same for the same.
  std::size_t lookOf(const std::function<void(Canvas&)>& paint);

  /// Edges are moved to whole pixels.
  void fill(const Rect& box, const Shade& shade);
  /// With smooth round corners and a border.
  void box(const Rect& box, const Shade& fill, const Shade& border, float radius, float width = 1);
  /// A button of a page; the first is what Return does.
  void button(const Rect& box, const std::string& words, bool first, bool under);
  /// A page in the middle of the window, which is veiled; the page.
  Rect page(const Rect& window, float width, float height);
  void disc(float x, float y, float radius, const Shade& fill, const Shade& border);
  /// A horizontal or vertical line, one pixel wide at scale 1.
  void rule(float x0, float y0, float x1, float y1, const Shade& shade);
  /// A smooth line.
  void polyline(
    const std::vector<std::pair<float, float>>& points, const Shade& shade, float width = 1);
  /// The whole image fills the box.
  void image(const Rect& box, vtkImageData* image);

  /// One line of text, its middle at height y.
  void text(float x, float y, const std::string& words, const TextLook& look = {});
  /// Width of the text in pixels.
  float textWidth(const std::string& words, const TextLook& look = {});
  /// The text, or as much of its beginning as fits, with an ellipsis.
  std::string fitted(const std::string& words, float width, const TextLook& look = {});
  /// The text in lines that fit, broken between words; the last one with what is beyond `most`.
  std::vector<std::string> lines(
    const std::string& words, float width, std::size_t most, const TextLook& look = {});

private:
  void useText(const TextLook& look);
  /// True if it is only asked for the look of what is painted, to which these values are added.
  template <typename... Values>
  bool notes(const Values&... values);

  vtkContext2D* Painter;
  float Scale;
  bool Empty;
  bool Notes = false;
  std::size_t Look = 0;
};

/// What a part of the window shows, by place: only what has changed is painted again.
class Painted
{
public:
  /// Paints over a box, unless the canvas shows the same there as it would then. Returns whether it
  /// has painted.
  bool update(Canvas& canvas, const Rect& box, const std::function<void(Canvas&)>& paint);

private:
  std::map<std::array<float, 4>, std::size_t> Looks; ///< by box
};
}

#endif
