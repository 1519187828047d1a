// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"

#include "Session.h"
#include "TextNumbers.h"

#include <cmath>

namespace stipple
{
namespace
{
/// Members of one object, in the order in which they were added.
class JsonObject
{
public:
  explicit JsonObject(int depth)
    : Indent(2 * depth, ' ')
  {
  }
  void add(const std::string& name, const std::string& json)
  {
    this->Members +=
      (this->Members.empty() ? "\n  " : ",\n  ") + this->Indent + '"' + name + "\": " + json;
  }
  void add(const std::string& name, long long value) { this->add(name, std::to_string(value)); }
  void add(const std::string& name, int value) { this->add(name, std::to_string(value)); }
  void add(const std::string& name, bool value)
  {
    this->add(name, std::string(value ? "true" : "false"));
  }
  void add(const std::string& name, double value)
  {
    this->add(name, std::isfinite(value) ? shortestText(value) : std::string("null"));
  }
  std::string text() const { return "{" + this->Members + "\n" + this->Indent + "}"; }

private:
  std::string Indent;
  std::string Members;
};

std::string qualityJson(const MeshQuality& quality, const MeshDistance& distance)
{
  JsonObject json(1);
  for (const QualityFigure& figure : figuresOf(quality, &distance))
  {
    switch (figure.kind)
    {
      case QualityFigure::Count:
        json.add(figure.name, static_cast<long long>(figure.value));
        break;
      case QualityFigure::Number:
        json.add(figure.name, figure.value);
        break;
      case QualityFigure::Truth:
        json.add(figure.name, figure.value != 0.);
        break;
    }
  }
  return json.text();
}
}

std::string toJson(const Report& report)
{
  JsonObject seconds(1);
  double total = 0;
  for (const auto& stage : report.seconds)
  {
    seconds.add(stage.first, std::round(stage.second * 1e4) / 1e4);
    total += stage.second;
  }
  seconds.add("total", std::round(total * 1e4) / 1e4);
  JsonObject repairs(1);
  for (const auto& repair : report.repairs)
  {
    repairs.add(repair.first, repair.second);
  }
  JsonObject json(0);
  json.add("stipple", quotedJson(STIPPLE_VERSION));
  json.add("input", quotedJson(report.input));
  json.add("output", quotedJson(report.output));
  json.add("input_points", report.inputPoints);
  json.add("input_faces", report.inputFaces);
  json.add("points", report.quality.numberOfPoints);
  json.add("triangles", report.quality.numberOfTriangles);
  json.add("charts", report.charts);
  json.add("components", report.quality.components);
  json.add("boundary_loops", report.quality.boundaryLoops);
  json.add("euler_characteristic", report.quality.euler);
  json.add("overlaps", report.overlaps);
  if (report.medianEdgeLength)
  {
    json.add("median_edge_length", *report.medianEdgeLength);
  }
  if (report.deviation)
  {
    json.add("deviation_pct", *report.deviation);
  }
  json.add("map_backend", quotedJson(report.mapBackend));
  json.add("seconds", seconds.text());
  json.add("repairs", repairs.text());
  json.add("quality", qualityJson(report.quality, report.distance));
  return json.text() + "\n";
}
}
