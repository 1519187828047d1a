// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "TypedNumber.h"

#include "SceneActors.h"
#include "TextNumbers.h"

#include <cmath>

namespace stipple
{
namespace
{
constexpr std::size_t MostLetters = 8;
}

void TypedNumber::begin(const std::string& text)
{
  this->On = true;
  this->Fresh = true;
  this->Text = text;
}

std::string TypedNumber::whyNot(double typed, double low, double high)
{
  const auto text = [](double value) {
    return value == std::floor(value) && std::abs(value) < 1e15
      ? grouped(static_cast<long long>(value))
      : shortestText(value);
  };
  return typed < low ? text(low) + " is the least here."
    : typed > high   ? text(high) + " is the most here."
                     : "";
}

bool TypedNumber::takes(char letter) const
{
  const bool isExponent = letter == 'e' && !this->Fresh && !this->Text.empty() &&
    this->Text.find('e') == std::string::npos;
  return (letter >= '0' && letter <= '9') || isExponent ||
    (!this->Whole && (letter == '.' || letter == '-'));
}

TypedNumber::End TypedNumber::key(const KeyStroke& stroke)
{
  if (stroke.symbol == "Return" || stroke.symbol == "KP_Enter" || stroke.symbol == "Tab")
  {
    return End::Accepted;
  }
  if (stroke.symbol == "Escape")
  {
    return End::GivenUp;
  }
  if (stroke.symbol == "BackSpace" || stroke.symbol == "Delete")
  {
    this->Text = this->Fresh ? "" : this->Text.substr(0, this->Text.size() - !this->Text.empty());
    this->Fresh = false;
  }
  else if (this->takes(stroke.letter) && (this->Fresh || this->Text.size() < MostLetters))
  {
    this->Text = (this->Fresh ? "" : this->Text) + stroke.letter;
    this->Fresh = false;
  }
  return End::None;
}
}
