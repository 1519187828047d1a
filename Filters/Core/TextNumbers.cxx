// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "TextNumbers.h"

#include <charconv>
#include <cmath>
#include <cstdlib>

namespace stipple
{
namespace
{
const char* skipPlus(const std::string& text)
{
  return text.data() + (text.size() > 1 && text[0] == '+' && text[1] != '-');
}
}

bool parseNumber(const std::string& text, double& value)
{
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(skipPlus(text), end, value);
  return result.ec == std::errc() && result.ptr == end && std::isfinite(value);
}

bool parseAnyNumber(std::string_view text, double& value)
{
  text.remove_prefix(text.size() > 1 && text[0] == '+');
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec == std::errc::result_out_of_range)
  {
    value = std::strtod(std::string(text).c_str(), nullptr); // infinity, or next to zero
  }
  return result.ec != std::errc::invalid_argument && result.ptr == text.data() + text.size();
}

bool parseWhole(std::string_view text, long long& value)
{
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  return result.ec == std::errc() && result.ptr == text.data() + text.size();
}

bool parseInteger(const std::string& text, long long low, long long high, int& value)
{
  const std::string_view digits = std::string_view(text).substr(skipPlus(text) - text.data());
  long long wide = 0;
  if (!parseWhole(digits, wide) || wide < low || wide > high)
  {
    return false;
  }
  value = static_cast<int>(wide);
  return true;
}

std::string shortestText(double value)
{
  char buffer[32];
  const auto result = std::to_chars(buffer, buffer + sizeof(buffer), value);
  return std::string(buffer, result.ptr);
}
}
