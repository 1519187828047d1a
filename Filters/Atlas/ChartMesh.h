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
  std::vector<Face> faces;         ///< faces of the surface, ascending
  std::vector<Triangle> triangles; ///< the chart's own vertices
  std::vector<int> vertices;    ///< surface point of every vertex; a point on a cut may occur twice
  std::vector<char> onBoundary; ///< by vertex
  std::vector<int> boundary;    ///< of the first boundary loop, counterclockwise
  int euler = 0;
  int boundaryLoops = 0; ///< 0, 1, or 2 for more

  bool isDisk() const { return this->euler == 1 && this->boundaryLoops == 1; }
  int numberOfVertices() const { return static_cast<int>(this->vertices.size()); }
};

/// Values of a chart's vertices, at the halfedges that leave them.
template <typename T>
void spread(const ChartMesh& chart, const std::vector<T>& value, ElementArray<Halfedge, T>& at)
{
  for (std::size_t i = 0; i < chart.faces.size(); ++i)
  {
    for (const Halfedge h : halfedgesOf(chart.faces[i]))
    {
      at[h] = value[chart.triangles[i][cornerOf(h)]];
    }
  }
}

/// The chart made of the given faces, which are connected and bounded by cut edges.
STIPPLEFILTERSATLAS_EXPORT ChartMesh extractChart(
  const CutSurface& surface, std::vector<Face> faces);

/// Faces of every chart (connected across edges that are not cut), charts by their smallest face.
STIPPLEFILTERSATLAS_EXPORT std::vector<std::vector<Face>> chartFaces(const CutSurface& surface);
}

#endif
