// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MessageText.h"

#include "TriangleSurface.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace stipple
{
std::string sentenceOf(const std::string& vtkMessage)
{
  std::string text = vtkMessage;
  const std::size_t firstLine = text.find('\n');
  const bool located = text.compare(0, 7, "ERROR: ") == 0 || text.compare(0, 9, "Warning: ") == 0 ||
    text.compare(0, 17, "Generic Warning: ") == 0;
  if (located && firstLine != std::string::npos)
  {
    text.erase(0, firstLine + 1);
    const std::size_t address = text.find(" (0x");
    const std::size_t colon = text.find("): ");
    if (address < colon && colon != std::string::npos && text.find_first_of(" \n") == address)
    {
      text.erase(0, colon + 3);
    }
  }
  for (char& c : text)
  {
    c = c == '\n' || c == '\r' ? ' ' : c;
  }
  const std::size_t end = text.find_last_not_of(' ');
  return text.substr(0, end == std::string::npos ? 0 : end + 1);
}

double twoDigits(double number)
{
  const double unit = std::pow(10., std::max(0., std::floor(std::log10(number)) - 1.));
  return unit * std::round(number / unit);
}

std::string countText(double number)
{
  constexpr double MostInFull = 1e15;
  std::ostringstream text;
  if (std::abs(number) < MostInFull)
  {
    text << std::fixed << std::setprecision(0);
  }
  text << number;
  return text.str();
}

std::string countOf(long long number, const std::string& one, const std::string& more)
{
  return std::to_string(number) + " " + (number == 1 ? one : more);
}

std::string differenceOf(const SurfaceTopology& topology, const SurfaceTopology& wanted)
{
  std::string text;
  const auto add = [&text](int number, int other, const std::string& what) {
    if (number != other)
    {
      text += (text.empty() ? "" : ", ") + what + " instead of " + std::to_string(other);
    }
  };
  add(topology.euler, wanted.euler, "Euler characteristic " + std::to_string(topology.euler));
  add(topology.boundaryLoops, wanted.boundaryLoops,
    countOf(topology.boundaryLoops, "boundary loop", "boundary loops"));
  add(topology.components, wanted.components,
    countOf(topology.components, "component", "components"));
  if (topology.manifold != wanted.manifold)
  {
    text += std::string(text.empty() ? "" : ", ") + (topology.manifold ? "" : "not ") + "manifold";
  }
  return text;
}
}
