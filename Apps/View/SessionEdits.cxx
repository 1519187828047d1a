// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SessionEdits.h"

#include "SizingFunction.h"

#include <algorithm>
#include <cmath>

namespace stipple
{
bool pointsFollow(const Session& session)
{
  return session.number("edge_length") > 0 ||
    (session.integer("points") == 0 &&
      (!session.text("size_array").empty() || session.number("curvature_points") > 0));
}

double pointsOfLength(const Session& session, double area)
{
  const double length = session.number("edge_length");
  return length > 0 ? area * densityOfEdges(std::max(length, session.number("size_minimum"))) : 0;
}

double pointsOfLevels(const Session& session, double area)
{
  const double base =
    pointsFollow(session) ? pointsOfLength(session, area) : session.number("points");
  // Each level adds a point an edge, and there are three edges a point.
  return session.text("pattern") == "semiregular"
    ? base * std::pow(4., session.number("subdivisions"))
    : 0;
}

bool followsImportance(const Session& session)
{
  return session.text("preset") != "uniform" || session.text("pattern") == "quads";
}

std::string whyImportanceRests(const Session& session)
{
  // As vtkControlMap has it, and vtkGeometryRemesher's presets.
  return session.number("curvature_points") > 0 ? "points per turn are set"
    : !session.text("size_array").empty()       ? "an array has lengths"
    : !followsImportance(session)               ? "the preset is uniform"
                                                : "";
}

void setPoints(Session& session, double points)
{
  session.set("points", points);
  session.reset("edge_length");
  session.reset("max_deviation");
}

void setNumber(Session& session, const std::string& option, double value, int points)
{
  session.set(option, value);
  // These two exclude each other.
  if (value > 0 && (option == "edge_length" || option == "max_deviation"))
  {
    session.reset(option == "edge_length" ? "max_deviation" : "edge_length");
  }
  if (option == "curvature_points" && session.text("size_array").empty())
  {
    session.set("points", value > 0 ? 0 : points);
  }
}

void setArray(Session& session, const std::string& option, const std::string& array, int points)
{
  session.set(option, array);
  if (option == "size_array" && session.number("curvature_points") == 0)
  {
    session.set("points", array.empty() ? points : 0);
  }
  else if (option == "importance_array" &&
    (!array.empty() || session.text("importance") == "array"))
  {
    session.set("importance", std::string(array.empty() ? FirstImportance : "array"));
  }
}

void removePicture(Session& session)
{
  session.reset("importance_image");
  if (session.text("importance") == "image")
  {
    session.set("importance", std::string(FirstImportance));
  }
}

void setBand(Session& session, int end, double value)
{
  std::vector<double> band = session.list("band_pass");
  band[static_cast<std::size_t>(end)] = value;
  band[0] = std::min(band[0], 0.9 * band[1]);
  session.setList("band_pass", band);
}

void spreadStrokes(Session& session, const Vec3& position, double radius, double widest)
{
  constexpr double Wider = 1.15; // a dab of the brush
  auto strokes = session.rows<5>("strokes");
  for (auto& stroke : strokes)
  {
    if (stroke[3] <= 0)
    {
      continue; // a region, which has its borders
    }
    const double wider = std::min(Wider, widest / stroke[3]);
    if (wider > 1 && (Vec3(stroke.data()) - position).norm() < radius)
    {
      stroke[3] *= wider;
      stroke[4] /= wider * wider;
    }
  }
  session.setRows("strokes", strokes);
}
}
