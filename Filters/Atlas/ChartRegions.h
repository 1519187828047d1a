// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The surface's triangles sorted into regions that are to become charts.
#ifndef stipple_ChartRegions_h
#define stipple_ChartRegions_h

#include "ChartMesh.h"
#include "ReportingThread.h"

namespace stipple
{
/// A seam between two regions: halfedges of the first, in order, each with the second across it.
struct STIPPLEFILTERSATLAS_EXPORT SeamArc
{
  std::vector<Halfedge> halfedges;
  bool closed = false; ///< it is the whole boundary of both regions

  double length(const TriangleSurface& surface) const;
  /// Whether all of it runs along creases.
  bool isSharp(const CutSurface& surface) const;
};

/// The longest of seams; there is one at least.
STIPPLEFILTERSATLAS_EXPORT const SeamArc& longest(
  const CutSurface& surface, const std::vector<SeamArc>& arcs);

/// Keeps the triangles of every region while edges are split and triangles change hands.
class STIPPLEFILTERSATLAS_EXPORT ChartRegions
{
public:
  /// Regions are what the surface's cut edges separate.
  explicit ChartRegions(CutSurface& surface, Stop stop = {});

  /// Whether the caller wants no more of it: long work on the regions gives up wherever it is.
  bool isStopped() const { return isAsked(this->WantsStop); }
  const Stop& stop() const { return this->WantsStop; }
  CutSurface& surface() { return this->Surface; }
  const CutSurface& surface() const { return this->Surface; }
  int size() const { return static_cast<int>(this->Faces.size()); }
  const std::vector<Face>& faces(int region) const { return this->Faces[region]; }
  int owner(Face face) const { return this->Owner[face]; }
  /// Region on the other side of a halfedge's edge, -1 beyond the surface's boundary.
  int ownerAcross(Halfedge h) const
  {
    return this->Surface.isBoundary(h) ? -1 : this->Owner[faceOf(this->Surface.twin[h])];
  }
  ChartMesh mesh(int region) const { return extractChart(this->Surface, this->Faces[region]); }
  double area(int region) const;
  /// Triangles of the region that splits did not add.
  int numberOfInputTriangles(int region) const;

  /// Edges around the region, and both sides of those cut inside it; counted up to `most`.
  int numberOfCuts(int region, int most) const;

  /// A triangle of the region that was split at an edge: its halfedge now ends at the new point,
  /// t of the way, and the triangle that was added has the corners new point, the halfedge's old
  /// head, the corner across.
  struct Split
  {
    Halfedge halfedge;
    double t;
    Face added;
  };
  /// Whether a region's extent or cuts changed since its mark was cleared; a new region is marked.
  bool isReshaped(int region) const { return this->Reshaped[region]; }
  /// The splits in the region since its mark was cleared, in order.
  const std::vector<Split>& splits(int region) const { return this->Splits[region]; }
  void clearChanges(int region)
  {
    this->Reshaped[region] = 0;
    this->Splits[region].clear();
  }

  /// CutSurface::splitEdge; the halves stay with their triangle's region. Returns the new point.
  int splitEdge(Halfedge h, double t);
  /// Cuts an edge inside a region.
  void cutOpen(Halfedge h);
  /// Cuts a region open along a path of edges, given by the vertices of the region's mesh. Returns
  /// a halfedge of each.
  std::vector<Halfedge> cutAlong(const ChartMesh& mesh, const std::vector<int>& path);
  /// Takes cuts inside a region back.
  void closeCuts(int region, const std::vector<Halfedge>& halfedges);
  /// Removes the cuts into the region that end inside it: they do not make it a disk.
  void closeSlits(int region);
  /// Splits every edge inside the region that joins two of its boundary's vertices: on a convex
  /// boundary it would leave a triangle without area.
  void splitChords(int region);

  /// Gives triangles of one region, those with side[i] != 0 for faces(region)[i], to a new region;
  /// cuts between the two. Returns the new region.
  int divide(int region, const std::vector<char>& side);
  /// Shares the triangles of two regions out anew: side by triangle of faces(a), then of faces(b);
  /// side 0 becomes a. Cuts the edges between them that are not; returns a halfedge of each.
  std::vector<Halfedge> shareOut(int a, int b, const std::vector<char>& side);

  /// Gives the triangles of b to a, closes a seam between them, and the last region takes b's
  /// number. Other seams between the two stay cut.
  void merge(int a, int b, const SeamArc& seam);

  /// The seams between two regions, from their smallest halfedge on.
  std::vector<SeamArc> arcs(int a, int b) const;
  /// The regions beside a region, ascending.
  std::vector<int> neighbours(int region) const;

private:
  CutSurface& Surface;
  Stop WantsStop;
  int NumberOfInputTriangles;
  ElementArray<Face, int> Owner;
  std::vector<std::vector<Face>> Faces;
  std::vector<char> Reshaped;
  std::vector<std::vector<Split>> Splits;
  ElementArray<Halfedge, char> TailOnBoundary; // all 0 in between; scratch
};
}

#endif
