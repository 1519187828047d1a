// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The left view: the input surface with the live preview as a texture of each chart (paper 3.3).
#ifndef stipple_BeforeScene_h
#define stipple_BeforeScene_h

#include "Session.h"
#include "ViewState.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkActor;
class vtkImageData;
class vtkPartitionedDataSetCollection;
class vtkPolyData;
class vtkRenderer;

namespace stipple
{
/// Squared length on the surface of a step (du, dv): uu du^2 + 2 uv du dv + vv dv^2.
struct SurfaceMetric
{
  double uu = 1;
  double uv = 0;
  double vv = 1;
};

class BeforeScene
{
public:
  /// `solid`: the back of the surface is never seen.
  BeforeScene(vtkRenderer* renderer, vtkPolyData* input, bool solid);
  ~BeforeScene();
  BeforeScene(const BeforeScene&) = delete;
  BeforeScene& operator=(const BeforeScene&) = delete;

  void setAtlas(vtkPartitionedDataSetCollection* charts, vtkPolyData* graph);
  /// New samples: halftones and control images.
  void setPreview(vtkPartitionedDataSetCollection* halftones,
    vtkPartitionedDataSetCollection* controls, long long numberOfSamples);
  void setView(const ViewState& view, float lineWidth);
  /// Constraints, tagged edges.
  void setMarks(const Session& session);
  /// The brush's outline on the surface; no radius: none.
  void setBrush(const Vec3& position, const Vec3& normal, double radius);
  /// Edges are drawn as far as they can be told apart; pixels per unit of length.
  void setZoom(double pixelsPerLength);

private:
  struct Chart
  {
    vtkSmartPointer<vtkActor> actor;
    vtkSmartPointer<vtkImageData> texture;
    std::vector<SurfaceMetric> metrics; ///< by triangle
  };
  void paintTextures();
  void showRightActors();

  vtkRenderer* Renderer;
  vtkPolyData* Input;
  bool Solid;
  double InputEdge;
  ViewState View;
  float LineWidth = 1;
  double Zoom = 0;
  double NumberOfSamples = 0;
  std::vector<Chart> Charts;
  vtkSmartPointer<vtkPartitionedDataSetCollection> Halftones;
  vtkSmartPointer<vtkPartitionedDataSetCollection> Controls;
  vtkSmartPointer<vtkActor> Surface;
  std::vector<vtkSmartPointer<vtkActor>> Lines; ///< sharp, boundary, seam
  vtkSmartPointer<vtkActor> Points;             ///< constraints
  vtkSmartPointer<vtkActor> Edges;              ///< tagged
  vtkSmartPointer<vtkActor> Brush;
};
}

#endif
