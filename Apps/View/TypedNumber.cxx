// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "TypedNumber.h"

#include "SceneActors.h"
#include "TextNumbers.h"

#include <algorithm>
#include <limits>

namespace stipple
{
namespace
{
constexpr std::size_t MostLetters = 12;

/// Without what stands between thousands, if it does: in "12,345" and "1.000.000", not in "2.5".
std::string withoutGroups(const std::string& text)
{
  std::string digits;
  std::size_t group = 0;
  bool isFirst = true;
  for (const char letter : text)
  {
    if (letter >= '0' && letter <= '9')
    {
      ++group;
      digits += letter;
      continue;
    }
    const bool isWhole = isFirst ? group >= 1 && group <= 3 && text[0] != '0' : group == 3;
    if ((letter != '.' && letter != ',') || !isWhole)
    {
      return text;
    }
    isFirst = false;
    group = 0;
  }
  return isFirst || group == 3 ? digits : text;
}
}

TypedNumber::TypedNumber(bool whole)
  : Whole(whole)
  , Line([whole](const std::string& rest, char letter) {
    // As many people write it; in a whole number it may be between thousands.
    const char sign = letter == ',' && !whole ? '.' : letter;
    const bool isExponent = sign == 'e' && !rest.empty() && rest.find('e') == std::string::npos;
    const bool isPart = (sign >= '0' && sign <= '9') || isExponent || sign == '.' ||
      (whole ? sign == ',' : sign == '-');
    return isPart && rest.size() < MostLetters ? sign : '\0';
  })
{
}

void TypedNumber::begin(const std::string& text)
{
  this->On = true;
  this->Touched = false;
  this->Line.set(text);
  this->Line.select(0, text.size());
}

bool TypedNumber::value(double& number) const
{
  if (!this->Whole)
  {
    return parseNumber(this->text(), number);
  }
  std::string plain = withoutGroups(this->text());
  std::replace(plain.begin(), plain.end(), ',', '.');
  return parseNumber(plain, number);
}

bool TypedNumber::isOpen(double low)
{
  return low == std::numeric_limits<double>::min();
}

std::string TypedNumber::whyNot(double typed, double low, double high)
{
  return typed < low && isOpen(low) ? "It has to be above 0."
    : typed < low                   ? numberText(low) + " is the least here."
    : typed > high                  ? numberText(high) + " is the most here."
                                    : "";
}

bool TypedNumber::key(const KeyStroke& stroke, End& end)
{
  end = End::None;
  const std::string before = this->text();
  if (stroke.symbol == "Return" || stroke.symbol == "KP_Enter" || stroke.symbol == "Tab")
  {
    end = End::Accepted;
  }
  else if (stroke.symbol == "Escape")
  {
    end = End::GivenUp;
  }
  else if (!this->Line.key(stroke) && stroke.control)
  {
    return false;
  }
  const bool changed = this->text() != before;
  this->Touched = this->Touched || changed;
  if (end == End::None && !changed && !stroke.control && stroke.letter > ' ')
  {
    end = End::Refused;
  }
  return true;
}

bool NumberControl::key(const KeyStroke& stroke)
{
  TypedNumber::End end;
  if (!this->Typed.on() || !this->Typed.key(stroke, end))
  {
    return false;
  }
  if (end == TypedNumber::End::Refused)
  {
    this->tell(std::string("\"") + stroke.letter + "\" is left out of the number.");
  }
  else if (end != TypedNumber::End::None)
  {
    this->finish(end == TypedNumber::End::Accepted);
  }
  return true;
}
}
