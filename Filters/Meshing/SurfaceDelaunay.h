// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// From Delaunay in the parameter plane to Delaunay on the surface: where a chart is squeezed or
// sheared, the plane's triangles are long and lie across what the surface goes around.
#ifndef stipple_SurfaceDelaunay_h
#define stipple_SurfaceDelaunay_h

#include "AtlasSurface.h"
#include "ReportingThread.h"
#include "StippleFiltersMeshingModule.h"
#include "TriangleComplex.h"

namespace stipple
{
/// Lengths on the surface of what is straight in a chart's parameter plane.
class STIPPLEFILTERSMESHING_EXPORT ParameterWalk
{
public:
  /// Borrows the surface.
  ParameterWalk(const AtlasSurface& surface, Chart chart);

  /// Goes straight from where it is (first somewhere in the chart) to a place of the rectangle.
  /// Returns the length of the way in units of the surface's points; less than zero, and it is
  /// where it was at first, if the way leaves the chart, which rounding on its sides may do.
  double walk(const Vec2& to);

private:
  void begin();

  const AtlasSurface& Surface;
  const ElementRange<Face> Faces;
  Face At;
  Vec2 Place = Vec2::Zero();
};

/// Swaps edges without a label in a triangulation of chart c, with the places of its vertices in
/// the plane, that are not Delaunay by lengths on the surface (Bobenko and Springborn 2007; edges
/// are straight in the plane, and not on the surface) and become shorter, as often as there are
/// any: the sum of lengths falls. All triangles stay counterclockwise in the plane. Returns the
/// number of swaps. Once `stop` is true, this ends early.
STIPPLEFILTERSMESHING_EXPORT int swapToSurfaceDelaunay(const AtlasSurface& surface, Chart c,
  const std::vector<Vec2>& parameter, TriangleComplex& complex, const Stop& stop = {});
}

#endif
