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
  static constexpr char Rounded = 2; ///< the mark of edges that setRounded() made sharp

  ElementArray<Halfedge, char> cut; ///< by halfedge, equal on twins; boundary edges are always cut
  ElementArray<Halfedge, char> sharp; ///< by halfedge, equal on twins: 0, 1, or Rounded
  ElementArray<Halfedge, Keep> keep;  ///< by halfedge, equal on twins: of edges that users name
  /// If not empty, by original point: whether it is an end of edges that are kept one by one. The
  /// others on such edges are passed by; without this list, all are ends.
  std::vector<char> isFixedPoint;
  std::vector<int> sourceCell;
  int numberOfOriginalPoints = 0;
  std::vector<EdgePoint> inserted; ///< of point numberOfOriginalPoints + i

  CutSurface() = default;
  CutSurface(TriangleSurface surface, std::vector<int> sourceCells);

  void setCut(Halfedge h, bool isCut);
  void setSharp(Halfedge h, bool isSharp);
  /// The edge is in the middle of a narrow band that turns: sharp to a mesh that is coarse.
  void setRounded(Halfedge h);
  bool isRounded(Halfedge h) const { return this->sharp[h] == Rounded; }
  /// Sharp to any mesh.
  bool isCrease(Halfedge h) const { return this->sharp[h] != 0 && !this->isRounded(h); }
  /// The edge is a feature that is to be kept so far at least.
  void setKeep(Halfedge h, Keep least);
  bool isFeature(Halfedge h) const { return this->sharp[h] != 0 || this->keep[h] != Keep::Nothing; }

  /// Splits the edge of h at tail + t (head - tail); returns the new point. New triangles are
  /// appended and inherit source cell and marks; halfedge h then ends at the new point.
  int splitEdge(Halfedge h, double t);

  /// Swaps the edge of h, which is neither cut nor a feature, between its two triangles for the
  /// edge between their other corners: h then runs from the corner over it, its twin back.
  void flipEdge(Halfedge h);

  /// The halfedge after h on the boundary of h's chart.
  Halfedge nextOnBoundary(Halfedge h) const;
  /// Cuts around the tail of h, two or more at the surface's boundary.
  int numberOfCutsAround(Halfedge h) const;

private:
  void link(Halfedge h, Halfedge t);
};

/// Carries a value at halfedges' tails over a split of the edge of h: h ends at the new point,
/// which `added`, the half that was cut off, leaves.
template <typename T>
void followSplit(ElementArray<Halfedge, T>& at, Halfedge h, Face added, const T& atNewPoint)
{
  at[halfedgeOf(added, 0)] = atNewPoint;
  at[halfedgeOf(added, 1)] = at[nextHalfedge(h)];
  at[halfedgeOf(added, 2)] = at[previousHalfedge(h)];
  at[nextHalfedge(h)] = atNewPoint;
}
}

#endif
