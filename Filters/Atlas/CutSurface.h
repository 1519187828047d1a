// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The surface being cut into charts: edges carry cut and crease marks, edges can be split.
#ifndef stipple_CutSurface_h
#define stipple_CutSurface_h

#include "FeatureGraph.h"
#include "StippleFiltersAtlasModule.h"
#include "TriangleSurface.h"

namespace stipple
{
/// Charts are the sets of triangles that are connected across edges that are not cut.
struct STIPPLEFILTERSATLAS_EXPORT CutSurface : TriangleSurface
{
  /// A point inserted on an edge: (1 - t) a + t b.
  struct EdgePoint
  {
    int a;
    int b;
    double t;
  };
  std::vector<char> cut;   ///< by halfedge, equal on twins; boundary edges are always cut
  std::vector<char> sharp; ///< by halfedge, equal on twins
  std::vector<Keep> keep;  ///< by halfedge, equal on twins: of edges that users name
  std::vector<int> sourceCell;
  int numberOfOriginalPoints = 0;
  std::vector<EdgePoint> inserted; ///< of point numberOfOriginalPoints + i

  CutSurface() = default;
  CutSurface(TriangleSurface surface, std::vector<int> sourceCells);

  void setCut(int h, bool isCut);
  void setSharp(int h, bool isSharp);
  /// The edge is a feature that is to be kept so far at least.
  void setKeep(int h, Keep least);
  bool isFeature(int h) const { return this->sharp[h] != 0 || this->keep[h] != Keep::Nothing; }
  using TriangleSurface::isBoundary;
  bool isBoundary(int h) const { return this->twin[h] < 0; }

  /// Splits the edge of h at tail + t (head - tail); returns the new point. New triangles are
  /// appended and inherit source cell and marks; halfedge h then ends at the new point.
  int splitEdge(int h, double t);

private:
  void link(int h, int t);
};
}

#endif
