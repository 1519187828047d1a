// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What makes the maps: the CPU rasteriser or an OpenGL context. Both follow MapRasterizer.h's
// rules.
#ifndef stipple_MapBackend_h
#define stipple_MapBackend_h

#include "MapRasterizer.h"

#include <string>

namespace stipple
{
class MapBackend
{
public:
  virtual ~MapBackend() = default;
  /// Makes ready to draw, or says why not; called before every execution.
  virtual Status initialize() { return Status::success(); }
  /// "CPU", or "OpenGL" with the renderer's name.
  virtual std::string name() const = 0;
  /// The triangle of every pixel; every pixel gets one.
  virtual Status faces(const MapChart& chart, int width, int height, int* faces) = 0;
  virtual Status maps(const MapChart& chart, int width, int height, const int* faces,
    const std::vector<MapRequest>& requests, const Progress& progress) = 0;
  /// Called after the last chart: another thread may be the next to draw.
  virtual void finish() {}
};

class CPUMapBackend : public MapBackend
{
public:
  std::string name() const override { return "CPU"; }
  Status faces(const MapChart& chart, int width, int height, int* faces) override
  {
    rasterizeFaces(chart, width, height, faces);
    fillUncoveredPixels(chart, width, height, faces);
    return Status::success();
  }
  Status maps(const MapChart& chart, int width, int height, const int* faces,
    const std::vector<MapRequest>& requests, const Progress& progress) override
  {
    return rasterizeMaps(chart, width, height, faces, requests, progress);
  }
};
} // namespace stipple

#endif
