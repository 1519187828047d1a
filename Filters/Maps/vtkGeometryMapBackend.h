// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeometryMapBackend
 * @brief   what vtkGeometryMapRenderer draws the maps with
 *
 * This class draws on the CPU and needs nothing but VTK's filters. Its subclass
 * vtkOpenGLGeometryMapBackend is registered with VTK's object factory as its override by the module
 * Stipple::RenderingGeometryMaps, as soon as that is linked or loaded: vtkGeometryMapRenderer finds
 * it there and knows nothing else of OpenGL.
 *
 * Charts, maps and status are types of the project's own (MapRasterizer.h, whose rules of coverage
 * hold for all back ends); there is nothing to call here from outside.
 *
 * @sa vtkGeometryMapRenderer vtkOpenGLGeometryMapBackend
 */
#ifndef vtkGeometryMapBackend_h
#define vtkGeometryMapBackend_h

#include "StippleFiltersMapsModule.h" // for export macro
#include "vtkObject.h"

#include <functional> // for progress
#include <string>     // for the name
#include <vector>     // for requests

class vtkWindow;

namespace stipple
{
class Status;
struct MapChart;
struct MapRequest;
}

class STIPPLEFILTERSMAPS_EXPORT vtkGeometryMapBackend : public vtkObject
{
public:
  /**
   * The CPU's, whatever overrides it.
   */
  static vtkGeometryMapBackend* New();
  vtkTypeMacro(vtkGeometryMapBackend, vtkObject);

  /**
   * What VTK's object factory has instead of the CPU's; null if there is none.
   */
  VTK_NEWINSTANCE static vtkGeometryMapBackend* NewOverride();

#ifndef __VTK_WRAP__
  /// The window whose context may be used; the caller keeps it. Null (the default): an own one.
  virtual void SetWindow(vtkWindow*) {}

  /// Whether AUTO takes this one rather than the CPU's.
  virtual bool IsPreferred()
  {
    return false;
  }

  /// Makes ready to draw, or says why not; called before every execution.
  virtual stipple::Status Initialize();

  /// "CPU", or "OpenGL" with the renderer's name; after Initialize().
  virtual std::string GetName()
  {
    return "CPU";
  }

  /// The triangle of every pixel; every pixel gets one.
  virtual stipple::Status DrawFaces(
    const stipple::MapChart& chart, int width, int height, int* faces);

  /// The maps from the faces.
  virtual stipple::Status DrawMaps(const stipple::MapChart& chart, int width, int height,
    const int* faces, const std::vector<stipple::MapRequest>& requests,
    const std::function<bool(double)>& progress);

  /// Called after the last chart: another thread may be the next to draw.
  virtual void Finish() {}
#endif

protected:
  vtkGeometryMapBackend() = default;
  ~vtkGeometryMapBackend() override = default;

private:
  vtkGeometryMapBackend(const vtkGeometryMapBackend&) = delete;
  void operator=(const vtkGeometryMapBackend&) = delete;
};

#endif
