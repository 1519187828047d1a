// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Canvas.h"

#include "vtkBrush.h"
#include "vtkContext2D.h"
#include "vtkFreeTypeTools.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPen.h"
#include "vtkRect.h"
#include "vtkSmartPointer.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <tuple>

namespace stipple
{
namespace
{
/// Boxes and words come again in every frame.
template <typename Key, typename Value>
using Cache = std::map<Key, Value>;
constexpr std::size_t CacheLimit = 2000;

std::uint32_t packed(const Shade& s)
{
  return static_cast<std::uint32_t>(s.r) << 24 | static_cast<std::uint32_t>(s.g) << 16 |
    static_cast<std::uint32_t>(s.b) << 8 | s.a;
}

/// How far a pixel's centre is inside a box with round corners.
float depthInside(float x, float y, float w, float h, float radius)
{
  const float dx = std::max({ radius - x, x - (w - radius), 0.F });
  const float dy = std::max({ radius - y, y - (h - radius), 0.F });
  const float corner = radius - std::hypot(dx, dy);
  return dx > 0 && dy > 0 ? corner : std::min({ x, y, w - x, h - y });
}

vtkSmartPointer<vtkImageData> drawBox(
  int w, int h, const Shade& fill, const Shade& border, float radius, float width)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(w, h, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int y = 0; y < h; ++y)
  {
    for (int x = 0; x < w; ++x, pixel += 4)
    {
      const float depth = depthInside(x + 0.5F, y + 0.5F, static_cast<float>(w),
        static_cast<float>(h), std::min({ radius, 0.5F * w, 0.5F * h }));
      const float cover = std::clamp(depth + 0.5F, 0.F, 1.F);
      const float inner = std::clamp(depth - width + 0.5F, 0.F, 1.F);
      const auto mixed = [inner](unsigned char outside, unsigned char inside) {
        return static_cast<unsigned char>(std::lround(
          (1 - inner) * static_cast<float>(outside) + inner * static_cast<float>(inside)));
      };
      pixel[0] = mixed(border.r, fill.r);
      pixel[1] = mixed(border.g, fill.g);
      pixel[2] = mixed(border.b, fill.b);
      pixel[3] = static_cast<unsigned char>(std::lround(cover * mixed(border.a, fill.a)));
    }
  }
  return image;
}

/// vtkFreeTypeTools loads a font by the first property of its look, and once more when so many
/// others came between that its cache was full. VTK 9.1 keeps that property itself: the painter's
/// would be another look by then.
void keepForFont(vtkTextProperty* property)
{
  using Look = std::tuple<int, int, std::array<double, 3>>;
  static std::set<Look> kept;
  std::array<double, 3> color;
  property->GetColor(color.data());
  if (kept.emplace(property->GetFontSize(), property->GetBold(), color).second)
  {
    vtkNew<vtkTextProperty> copy;
    copy->ShallowCopy(property);
    std::size_t id = 0;
    vtkFreeTypeTools::GetInstance()->MapTextPropertyToId(copy, &id);
  }
}
}

template <typename... Values>
bool Canvas::notes(const Values&... values)
{
  if (this->Notes)
  {
    // As boost::hash_combine does it.
    ((this->Look ^=
       std::hash<Values>{}(values) + 0x9e3779b9 + (this->Look << 6) + (this->Look >> 2)),
      ...);
  }
  return this->Notes;
}

std::size_t Canvas::lookOf(const std::function<void(Canvas&)>& paint)
{
  this->Notes = true;
  this->Look = 0;
  paint(*this);
  this->Notes = false;
  return this->Look;
}

bool Painted::update(Canvas& canvas, const Rect& box, const std::function<void(Canvas&)>& paint)
{
  const std::size_t look = canvas.lookOf(paint);
  std::size_t& shown = this->Looks[{ { box.x, box.y, box.w, box.h } }];
  if (!canvas.empty() && shown == look)
  {
    return false;
  }
  shown = look;
  canvas.fill(box, shades::Ground);
  paint(canvas);
  return true;
}

void Canvas::fill(const Rect& box, const Shade& shade)
{
  if (this->notes(box.x, box.y, box.w, box.h, packed(shade)))
  {
    return;
  }
  this->Painter->GetPen()->SetLineType(vtkPen::NO_PEN);
  this->Painter->GetBrush()->SetColor(shade.r, shade.g, shade.b, shade.a);
  const float x = std::round(box.x);
  const float y = std::round(box.y);
  this->Painter->DrawRect(x, y, std::round(box.right()) - x, std::round(box.top()) - y);
}

void Canvas::box(const Rect& box, const Shade& fill, const Shade& border, float radius, float width)
{
  if (this->notes(box.x, box.y, box.w, box.h, packed(fill), packed(border), radius, width))
  {
    return;
  }
  using Key = std::tuple<int, int, std::uint32_t, std::uint32_t, float, float>;
  static Cache<Key, vtkSmartPointer<vtkImageData>> cache;
  const float x = std::round(box.x);
  const float y = std::round(box.y);
  const int w = std::max(1, static_cast<int>(std::round(box.right()) - x));
  const int h = std::max(1, static_cast<int>(std::round(box.top()) - y));
  if (cache.size() > CacheLimit)
  {
    cache.clear();
  }
  vtkSmartPointer<vtkImageData>& image =
    cache[Key(w, h, packed(fill), packed(border), radius * this->Scale, width * this->Scale)];
  if (!image)
  {
    image = drawBox(w, h, fill, border, radius * this->Scale, width * this->Scale);
  }
  this->image({ x, y, static_cast<float>(w), static_cast<float>(h) }, image);
}

Rect Canvas::page(const Rect& window, float width, float height)
{
  const Rect page{ window.x + 0.5F * (window.w - width), window.y + 0.5F * (window.h - height),
    width, height };
  this->fill(window, { 30, 36, 46, 110 });
  this->box(page, shades::Card, shades::Line, 8);
  return page;
}

void Canvas::disc(float x, float y, float radius, const Shade& fill, const Shade& border)
{
  const float d = 2 * std::round(radius * this->Scale);
  this->box({ x - 0.5F * d, y - 0.5F * d, d, d }, fill, border, radius, 2);
}

void Canvas::rule(float x0, float y0, float x1, float y1, const Shade& shade)
{
  const float width = std::max(1.F, std::floor(this->Scale));
  const float x = std::floor(std::min(x0, x1));
  const float y = std::floor(std::min(y0, y1));
  this->fill(
    { x, y, y0 == y1 ? std::abs(x1 - x0) : width, y0 == y1 ? width : std::abs(y1 - y0) }, shade);
}

void Canvas::polyline(
  const std::vector<std::pair<float, float>>& points, const Shade& shade, float width)
{
  for (const auto& [x, y] : points)
  {
    this->notes(x, y);
  }
  if (this->notes(packed(shade), width))
  {
    return;
  }
  // Each piece fades out over a pixel on both sides.
  this->Painter->GetPen()->SetLineType(vtkPen::NO_PEN);
  this->Painter->GetBrush()->SetColor(shade.r, shade.g, shade.b, shade.a);
  const float half = 0.5F * width * this->Scale;
  const float offsets[4] = { -half - 0.5F, -half + 0.5F, half - 0.5F, half + 0.5F };
  const unsigned char alphas[4] = { 0, shade.a, shade.a, 0 };
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
  {
    const float dx = points[i + 1].first - points[i].first;
    const float dy = points[i + 1].second - points[i].second;
    const float length = std::hypot(dx, dy);
    for (int band = 0; length > 0 && band < 3; ++band)
    {
      float corners[8];
      unsigned char colors[16];
      for (int corner = 0; corner < 4; ++corner)
      {
        const auto& end = points[i + (corner == 1 || corner == 2 ? 1 : 0)];
        const int side = band + (corner >= 2 ? 1 : 0);
        corners[2 * corner] = end.first - offsets[side] * dy / length;
        corners[2 * corner + 1] = end.second + offsets[side] * dx / length;
        const unsigned char color[4] = { shade.r, shade.g, shade.b, alphas[side] };
        std::copy_n(color, 4, colors + 4 * corner);
      }
      this->Painter->DrawPolygon(corners, 4, colors, 4);
    }
  }
}

void Canvas::button(const Rect& box, const std::string& words, bool first, bool under)
{
  this->box(box, first ? shades::Accent : (under ? shades::Hover : shades::Card),
    first || under ? shades::Accent : shades::Line, 4, under ? 2 : 1);
  const TextLook look{ 12, first ? shades::Card : shades::Word, Align::Center, first };
  this->text(box.x + 0.5F * box.w, box.y + 0.5F * box.h,
    this->fitted(words, box.w - 8 * this->Scale, look), look);
}

void Canvas::image(const Rect& box, vtkImageData* image)
{
  if (this->notes(box.x, box.y, box.w, box.h, image, image->GetMTime()))
  {
    return;
  }
  this->Painter->DrawImage(vtkRectf(box.x, box.y, box.w, box.h), image);
}

void Canvas::useText(const TextLook& look)
{
  vtkTextProperty* property = this->Painter->GetTextProp();
  property->SetFontFamilyToArial();
  property->SetFontSize(static_cast<int>(std::lround(look.size * this->Scale)));
  property->SetBold(look.bold);
  property->SetColor(look.shade.r / 255., look.shade.g / 255., look.shade.b / 255.);
  property->SetOpacity(1.);
  property->SetOrientation(0.);
  property->SetVerticalJustificationToCentered();
  property->SetJustification(look.align == Align::Left ? VTK_TEXT_LEFT
      : look.align == Align::Center                    ? VTK_TEXT_CENTERED
                                                       : VTK_TEXT_RIGHT);
  keepForFont(property);
}

void Canvas::text(float x, float y, const std::string& words, const TextLook& look)
{
  if (words.empty() ||
    this->notes(
      x, y, words, look.size, packed(look.shade), static_cast<int>(look.align), look.bold))
  {
    return;
  }
  this->useText(look);
  // On whole pixels letters stay sharp.
  this->Painter->DrawString(std::round(x), std::round(y), words.c_str());
}

float Canvas::textWidth(const std::string& words, const TextLook& look)
{
  if (words.empty())
  {
    return 0;
  }
  using Key = std::tuple<std::string, long, bool>;
  static Cache<Key, float> cache;
  if (cache.size() > CacheLimit)
  {
    cache.clear();
  }
  const Key key(words, std::lround(look.size * this->Scale), look.bold);
  const auto known = cache.find(key);
  if (known != cache.end())
  {
    return known->second;
  }
  TextLook left = look;
  left.align = Align::Left;
  this->useText(left);
  float bounds[4];
  this->Painter->ComputeStringBounds(words.c_str(), bounds);
  return cache[key] = bounds[2];
}

std::string Canvas::fitted(const std::string& words, float width, const TextLook& look)
{
  if (this->textWidth(words, look) <= width)
  {
    return words;
  }
  std::string text = words;
  while (!text.empty() && this->textWidth(text + "...", look) > width)
  {
    do
    {
      text.pop_back();
    } while (!text.empty() && (text.back() & 0xC0) == 0x80); // not within a letter of UTF-8
  }
  return text + "...";
}

std::vector<std::string> Canvas::lines(
  const std::string& words, float width, std::size_t most, const TextLook& look)
{
  std::vector<std::string> result;
  std::string rest = words;
  while (result.size() + 1 < most && this->textWidth(rest, look) > width)
  {
    std::size_t end = rest.rfind(' ');
    while (
      end != std::string::npos && end > 0 && this->textWidth(rest.substr(0, end), look) > width)
    {
      end = rest.rfind(' ', end - 1);
    }
    if (end == std::string::npos || end == 0)
    {
      break;
    }
    result.push_back(rest.substr(0, end));
    rest.erase(0, end + 1);
  }
  result.push_back(this->fitted(rest, width, look));
  return result;
}
}
