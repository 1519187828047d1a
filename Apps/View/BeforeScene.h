// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The left view: the input surface with the live preview as a texture of each chart (paper 3.3).
#ifndef stipple_BeforeScene_h
#define stipple_BeforeScene_h

#include "MeshColors.h"
#include "SampleTextures.h"
#include "Session.h"
#include "SurfacePicker.h"
#include "ViewState.h"

#include "vtkSmartPointer.h"

#include <array>
#include <memory>
#include <vector>

class vtkActor;
class vtkImageData;
class vtkPartitionedDataSetCollection;
class vtkPolyData;
class vtkRenderer;

namespace stipple
{
class BeforeScene
{
public:
  /// `solid`: the back of the surface is never seen.
  BeforeScene(vtkRenderer* renderer, vtkPolyData* input, bool solid);
  ~BeforeScene();
  BeforeScene(const BeforeScene&) = delete;
  BeforeScene& operator=(const BeforeScene&) = delete;

  void setAtlas(vtkPartitionedDataSetCollection* charts, vtkPolyData* graph);
  /// Sharp lines that are creases to the mesh that is to be: the others are not shown.
  void setCreases(vtkPolyData* creases);
  int numberOfCharts() const { return static_cast<int>(this->Charts.size()); }
  /// Whether sharp edges are known, those of the model or tagged.
  bool hasFeatures() const;
  /// How dense samples are wanted, an image a chart (densityImages()).
  void setDensity(std::vector<vtkSmartPointer<vtkImageData>> density);
  /// The samples, or a mesh's vertices.
  void setDots(std::shared_ptr<const DotImages> dots);
  /// `colors` has how far the input's points are from the mesh; it is not kept alive.
  void setMissed(const MeshColors& colors);
  void setView(const ViewState& view, float lineWidth);
  /// Constraints, tagged edges. Whether they are others than before.
  bool setMarks(const Session& session);
  /// The brush's outline on the surface: circles of that radius around these places.
  void setBrush(const std::vector<PickedPlace>& places, double radius);
  void hideBrush() { this->setBrush({}, 0); }
  /// Edges of the input that a click would tag, in the brush's place.
  void setEdgesUnder(const std::vector<std::array<vtkIdType, 2>>& edges);
  /// The picked points, to be shown in another view as well.
  vtkActor* points();
  /// Edges are drawn as far as they can be told apart; pixels per unit of length.
  void setZoom(double pixelsPerLength);
  /// The input's edges are asked for, and too short to be seen.
  bool hidesEdges() const;
  /// Whether samples that are so far apart are less than a pixel.
  bool hidesDots(double spacing) const;

private:
  /// In one colour, or coloured by density.
  struct Chart
  {
    vtkSmartPointer<vtkActor> actor;
    vtkSmartPointer<vtkImageData> texture;
  };
  void showTextures();
  void paintMissed();
  void showRightActors();

  vtkRenderer* Renderer;
  vtkPolyData* Input;
  bool Solid;
  double InputEdge;
  ViewState View;
  float LineWidth = 1;
  double Zoom = 0;
  const MeshColors* Missed = nullptr;
  std::vector<Chart> Charts;
  SampleTextures Samples;
  std::shared_ptr<const DotImages> Dots;              ///< that are shown
  std::vector<vtkSmartPointer<vtkImageData>> Density; ///< by chart
  vtkSmartPointer<vtkActor> Surface;
  vtkSmartPointer<vtkActor> Wires;              ///< the input's edges alone
  std::vector<vtkSmartPointer<vtkActor>> Lines; ///< sharp, boundary, seam
  vtkSmartPointer<vtkActor> Points;             ///< constraints
  vtkSmartPointer<vtkActor> Edges;              ///< tagged
  vtkSmartPointer<vtkActor> Brush;
  std::vector<double> Marks; ///< that are shown, as the session has them
};
}

#endif
