// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Canvas.h"

#include "vtkBrush.h"
#include "vtkContext2D.h"
#include "vtkImageData.h"
#include "vtkPen.h"
#include "vtkRect.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>

namespace stipple
{
std::vector<float> Canvas::outline(const Rect& box, float radius) const
{
  constexpr int Steps = 5;
  constexpr float QuarterTurn = 1.57079633F;
  const float r = std::min({ radius, 0.5F * box.w, 0.5F * box.h });
  std::vector<float> points;
  const float centers[4][2] = { { box.right() - r, box.top() - r }, { box.x + r, box.top() - r },
    { box.x + r, box.y + r }, { box.right() - r, box.y + r } };
  for (int corner = 0; corner < 4; ++corner)
  {
    for (int step = 0; step <= (r > 0 ? Steps : 0); ++step)
    {
      const float angle = QuarterTurn * (corner + static_cast<float>(step) / Steps);
      points.push_back(centers[corner][0] + r * std::cos(angle));
      points.push_back(centers[corner][1] + r * std::sin(angle));
    }
  }
  return points;
}

void Canvas::fill(const Rect& box, const Shade& shade, float radius)
{
  this->Painter->GetPen()->SetLineType(vtkPen::NO_PEN);
  this->Painter->GetBrush()->SetColor(shade.r, shade.g, shade.b, shade.a);
  std::vector<float> points = this->outline(box, radius * this->Scale);
  this->Painter->DrawPolygon(points.data(), static_cast<int>(points.size() / 2));
}

void Canvas::frame(const Rect& box, const Shade& shade, float radius, float width)
{
  vtkPen* pen = this->Painter->GetPen();
  pen->SetLineType(vtkPen::SOLID_LINE);
  pen->SetColor(shade.r, shade.g, shade.b, shade.a);
  pen->SetWidth(width * this->Scale);
  std::vector<float> points = this->outline(box.inset(0.5F), radius * this->Scale);
  points.push_back(points[0]);
  points.push_back(points[1]);
  this->Painter->DrawPoly(points.data(), static_cast<int>(points.size() / 2));
}

void Canvas::line(float x0, float y0, float x1, float y1, const Shade& shade, float width)
{
  this->polyline({ { x0, y0 }, { x1, y1 } }, shade, width);
}

void Canvas::polyline(
  const std::vector<std::pair<float, float>>& points, const Shade& shade, float width)
{
  vtkPen* pen = this->Painter->GetPen();
  pen->SetLineType(vtkPen::SOLID_LINE);
  pen->SetColor(shade.r, shade.g, shade.b, shade.a);
  pen->SetWidth(width * this->Scale);
  std::vector<float> places;
  for (const auto& p : points)
  {
    places.push_back(p.first);
    places.push_back(p.second);
  }
  if (points.size() > 1)
  {
    this->Painter->DrawPoly(places.data(), static_cast<int>(points.size()));
  }
}

void Canvas::disc(float x, float y, float radius, const Shade& fill, const Shade& border)
{
  const float r = radius * this->Scale;
  const Rect box{ x - r, y - r, 2 * r, 2 * r };
  this->fill(box, border, radius);
  this->fill(box.inset(1.5F * this->Scale), fill, radius);
}

void Canvas::image(const Rect& box, vtkImageData* image)
{
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
}

void Canvas::text(float x, float y, const std::string& words, const TextLook& look)
{
  if (words.empty())
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
  TextLook left = look;
  left.align = Align::Left;
  this->useText(left);
  float bounds[4];
  this->Painter->ComputeStringBounds(words.c_str(), bounds);
  return bounds[2];
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
}
