// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// One chart as a mesh of its own: its triangles, its vertices (cut edges separate them), its
// boundary.
#ifndef stipple_ChartMesh_h
#define stipple_ChartMesh_h

#include "CutSurface.h"

namespace stipple
{
struct STIPPLEFILTERSATLAS_EXPORT ChartMesh
{
  std::vector<int> faces;          ///< faces of the surface, ascending
  std::vector<Triangle> triangles; ///< the chart's own vertices
  std::vector<int> vertices;    ///< surface point of every vertex; a point on a cut may occur twice
  std::vector<char> onBoundary; ///< by vertex
  std::vector<int> boundary;    ///< the boundary vertices, counterclockwise, if the chart is a disk
  int euler = 0;

  bool isDisk() const { return this->euler == 1; }
  int numberOfVertices() const { return static_cast<int>(this->vertices.size()); }
};

/// The chart made of the given faces, which are connected and bounded by cut edges.
STIPPLEFILTERSATLAS_EXPORT ChartMesh extractChart(
  const CutSurface& surface, std::vector<int> faces);

/// Faces of every chart (connected across edges that are not cut), charts by their smallest face.
STIPPLEFILTERSATLAS_EXPORT std::vector<std::vector<int>> chartFaces(const CutSurface& surface);

/// Splits every chord (an uncut edge between two boundary vertices) in the middle: on a convex
/// boundary it would leave a triangle without area. Returns the number of splits; the faces' list
/// is extended.
STIPPLEFILTERSATLAS_EXPORT int splitChords(CutSurface& surface, std::vector<int>& faces);
}

#endif
