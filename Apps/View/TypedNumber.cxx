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
constexpr std::size_t MostLetters = 24;

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
    // As many people write it; in a whole number it may be between thousands. What is no number is
    // told once it is all there: without the letter, 12k would be 12.
    const char sign = letter == ',' && !whole ? '.' : letter;
    return letter > ' ' && rest.size() < MostLetters ? sign : '\0';
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

std::string TypedNumber::whyNot(double typed, double low, double high)
{
  // A range without a least number has all above 0, as the table of options says it.
  const bool isOpen = low == std::numeric_limits<double>::min();
  return typed < low && isOpen ? "It has to be above 0."
    : typed < low              ? numberText(low) + " is the least here."
    : typed > high             ? numberText(high) + " is the most here."
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
  this->Touched = this->Touched || this->text() != before;
  return true;
}

bool NumberControl::takeTyped(double& value) const
{
  const bool isNumber = this->Typed.value(value);
  if (!isNumber && !this->Typed.text().empty())
  {
    this->tell(this->Typed.text() + " is no number.");
  }
  return isNumber;
}

bool NumberControl::key(const KeyStroke& stroke)
{
  TypedNumber::End end;
  if (!this->Typed.on() || !this->Typed.key(stroke, end))
  {
    return false;
  }
  if (end != TypedNumber::End::None)
  {
    this->finish(end == TypedNumber::End::Accepted);
  }
  return true;
}
}
