// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The right view: the remesh with its edges and feature lines.
#ifndef stipple_AfterScene_h
#define stipple_AfterScene_h

#include "MeshColors.h"
#include "ViewState.h"

#include "vtkSmartPointer.h"

class vtkActor;
class vtkPolyData;
class vtkRenderer;

namespace stipple
{
class AfterScene
{
public:
  /// `solid`: the back of the surface is never seen.
  AfterScene(vtkRenderer* renderer, bool solid);
  ~AfterScene();
  AfterScene(const AfterScene&) = delete;
  AfterScene& operator=(const AfterScene&) = delete;

  /// `colors`, a number a cell, is not kept alive.
  void setMesh(vtkPolyData* mesh, vtkPolyData* lines, const MeshColors& colors);
  /// Features of the input that the mesh has not; null: none.
  void setLost(vtkPolyData* lines);
  /// Those, to be shown in another view as well.
  vtkActor* lost();
  /// A cell that stands out; -1: none.
  void setMarked(int cell);
  int marked() const { return this->Marked; }
  void setView(const ViewState& view, float lineWidth);
  /// Pixels per unit of length.
  void setZoom(double pixelsPerLength);
  /// There are edges, too short to be seen.
  bool hidesEdges() const;

private:
  void showRightActors();
  void paintTriangles();

  ViewState View;
  float LineWidth = 1;
  double Zoom = 0;
  double MeshEdge = 0;
  const MeshColors* Colors = nullptr;
  vtkSmartPointer<vtkPolyData> Surface;
  int Marked = -1;
  vtkSmartPointer<vtkActor> Mesh;
  vtkSmartPointer<vtkActor> Wires;    ///< the mesh's edges alone
  vtkSmartPointer<vtkActor> Lines[3]; ///< sharp, boundary, seam
  vtkSmartPointer<vtkActor> Lost;     ///< features that the mesh has not
  vtkSmartPointer<vtkActor> Mark;     ///< the outline of the marked cell
};
}

#endif
