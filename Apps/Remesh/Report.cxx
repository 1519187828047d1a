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

/// The names of the figures that this project's measurements use everywhere.
std::string qualityJson(const MeshQuality& q, const MeshDistance& d)
{
  JsonObject json(1);
  json.add("V", q.numberOfPoints);
  json.add("F", q.numberOfTriangles);
  json.add("isolated", q.isolatedPoints);
  json.add("nonmanifold_edges", q.nonManifoldEdges);
  json.add("boundary_edges", q.boundaryEdges);
  json.add("misoriented_edges", q.misorientedEdges);
  json.add("nonmanifold_vertices", q.nonManifoldVertices);
  json.add("components", q.components);
  json.add("boundary_loops", q.boundaryLoops);
  json.add("euler", q.euler);
  json.add("genus", q.genus);
  json.add("degenerate", q.degenerate);
  json.add("Qmin", q.minimumQ);
  json.add("Qavg", q.averageQ);
  json.add("angle_min", q.minimumAngle);
  json.add("angle_min_avg", q.averageMinimumAngle);
  json.add("angle_max", q.maximumAngle);
  json.add("pct_lt30", q.percentBelow30);
  json.add("pct_gt90", q.percentAbove90);
  json.add("V6_pct", q.percentValence6);
  json.add("V567_pct", q.percentValence567);
  json.add("area_cv", q.areaVariation);
  json.add("edge_cv", q.edgeVariation);
  json.add("area", q.area);
  json.add("rms_pct", d.rmsPercent);
  json.add("hausdorff_pct", d.hausdorffPercent);
  json.add("area_ratio", d.areaRatio);
  json.add("same_topology", d.sameTopology);
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
  json.add("map_backend", quotedJson(report.mapBackend));
  json.add("seconds", seconds.text());
  json.add("repairs", repairs.text());
  json.add("quality", qualityJson(report.quality, report.distance));
  return json.text() + "\n";
}
}
