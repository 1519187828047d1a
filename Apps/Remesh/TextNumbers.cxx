// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "TextNumbers.h"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <sstream>

namespace stipple
{
namespace
{
const char* skipPlus(const std::string& text)
{
  return text.data() + (text.size() > 1 && text[0] == '+' && text[1] != '-');
}

/// Calls back with the words of every line that has any; stops at the first complaint.
Status readWords(const std::string& file,
  const std::function<std::string(const std::vector<std::string>&)>& readLine)
{
  std::ifstream stream(file);
  if (!stream)
  {
    return Status::error("cannot read '" + file + "'");
  }
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number)
  {
    std::istringstream text(line.substr(0, line.find('#')));
    std::vector<std::string> words;
    for (std::string word; text >> word;)
    {
      words.push_back(word);
    }
    const std::string wrong = words.empty() ? "" : readLine(words);
    if (!wrong.empty())
    {
      return Status::error(file + ":" + std::to_string(number) + ": " + wrong);
    }
  }
  return stream.bad() ? Status::error("cannot read '" + file + "'") : Status::success();
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

bool parseInteger(const std::string& text, long long low, long long high, int& value)
{
  const char* end = text.data() + text.size();
  long long wide = 0;
  const auto result = std::from_chars(skipPlus(text), end, wide);
  if (result.ec != std::errc() || result.ptr != end || wide < low || wide > high)
  {
    return false;
  }
  value = static_cast<int>(wide);
  return true;
}

std::string parseTransfer(const std::string& text, std::vector<std::pair<double, double>>& points)
{
  points.clear();
  std::istringstream stream(text);
  for (std::string item; std::getline(stream, item, ',');)
  {
    const std::size_t colon = item.find(':');
    std::pair<double, double> p;
    if (colon == std::string::npos || !parseNumber(item.substr(0, colon), p.first) ||
      !parseNumber(item.substr(colon + 1), p.second))
    {
      return "needs X0:Y0,X1:Y1,..., but '" + item + "' is no X:Y";
    }
    if (p.first < 0 || p.first > 1 || p.second < 0 || p.second > 1)
    {
      return "needs X and Y from 0 to 1, but '" + item + "' is outside";
    }
    if (!points.empty() && p.first <= points.back().first)
    {
      return "needs ascending X, but '" + item + "' does not follow the one before";
    }
    points.push_back(p);
  }
  return points.size() < 2 ? "needs at least two points X0:Y0,X1:Y1" : "";
}

std::string shortestText(double value)
{
  char buffer[32];
  const auto result = std::to_chars(buffer, buffer + sizeof(buffer), value);
  return std::string(buffer, result.ptr);
}

Status readPositions(const std::string& file, std::vector<Vec3>& positions)
{
  positions.clear();
  return readWords(file, [&](const std::vector<std::string>& words) -> std::string {
    Vec3 p;
    if (words.size() != 3 || !parseNumber(words[0], p[0]) || !parseNumber(words[1], p[1]) ||
      !parseNumber(words[2], p[2]))
    {
      return "a constraint is three finite numbers, x y z";
    }
    positions.push_back(p);
    return {};
  });
}

Status readStrokes(const std::string& file, std::vector<std::array<double, 5>>& strokes)
{
  strokes.clear();
  return readWords(file, [&](const std::vector<std::string>& words) -> std::string {
    std::array<double, 5> stroke;
    bool good = words.size() == stroke.size();
    for (std::size_t i = 0; good && i < stroke.size(); ++i)
    {
      good = parseNumber(words[i], stroke[i]);
    }
    if (!good)
    {
      return "is no stroke 'x y z radius strength'";
    }
    if (stroke[3] <= 0 || stroke[4] < -1)
    {
      return "needs a positive radius and a strength of at least -1";
    }
    strokes.push_back(stroke);
    return {};
  });
}

Status readEdges(
  const std::string& file, long long numberOfPoints, std::vector<std::array<long long, 2>>& edges)
{
  edges.clear();
  return readWords(file, [&](const std::vector<std::string>& words) -> std::string {
    int ids[2];
    if (words.size() != 2 || !parseInteger(words[0], 0, numberOfPoints - 1, ids[0]) ||
      !parseInteger(words[1], 0, numberOfPoints - 1, ids[1]))
    {
      return "a feature edge is two point ids from 0 to " + std::to_string(numberOfPoints - 1);
    }
    if (ids[0] == ids[1])
    {
      return "a feature edge joins two different points";
    }
    edges.push_back({ ids[0], ids[1] });
    return {};
  });
}
}
