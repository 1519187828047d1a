// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The look of surfaces, edges, features and charts in every picture and window of the programs.
#ifndef stipple_SceneActors_h
#define stipple_SceneActors_h

#include "vtkSmartPointer.h"

#include <array>
#include <string>

class vtkActor;
class vtkPolyData;
class vtkProperty;
class vtkRenderer;

namespace stipple
{
using Color = std::array<double, 3>;
constexpr Color Ink = { { 0.16, 0.18, 0.21 } };
constexpr Color Paper = { { 1., 1., 1. } };
constexpr Color Clay = { { 0.82, 0.86, 0.91 } };
constexpr Color Edge = { { 0.24, 0.28, 0.34 } };
constexpr Color FeatureRed = { { 0.86, 0.10, 0.13 } };
constexpr Color BoundaryBlue = { { 0.10, 0.32, 0.70 } };
constexpr Color SampleBlue = { { 0.10, 0.20, 0.42 } };

/// A direction from which most models show three of their sides; y is up.
constexpr Color ViewFrom = { { 0.55, 0.38, 1.0 } };
constexpr double ViewAngle = 24; ///< degrees

/// 1234567 as "1,234,567".
[[nodiscard]] std::string grouped(long long number);
/// Any number: grouped where it is whole and not beyond what doubles count.
[[nodiscard]] std::string numberText(double number);

/// A light colour for each chart; neighbours in number are far apart in hue.
[[nodiscard]] std::array<unsigned char, 3> chartColor(int chart);

/// The surface's points and polygons and nothing else: no array of the user's colours it.
[[nodiscard]] vtkSmartPointer<vtkPolyData> bareSurface(vtkPolyData* mesh);

/// Flat shading in the colour of clay.
void setSurfaceLook(vtkProperty* property);
/// How strong that is: fainter where colours stand for values, which are to be those of the legend.
void setShading(vtkProperty* property, bool hasLegend);

/// Edges if they are more than some pixels long, the fainter the shorter; a line is as wide as
/// `scale` pixels, or half of that for short edges.
void setEdgeLook(vtkProperty* property, double pixels, double scale);

/// The same for a window that is looked at closely: dark, and so thin that what lies between short
/// edges stays light; none where they would hide the shading.
void setInspectionEdgeLook(vtkProperty* property, double pixels, double scale);
[[nodiscard]] bool showsInspectionEdges(double pixels);

/// Unlit lines in one colour.
[[nodiscard]] vtkSmartPointer<vtkActor> lineActor(
  vtkPolyData* lines, const Color& color, double width);

/// The edges of a surface's triangles and nothing else, unlit.
[[nodiscard]] vtkSmartPointer<vtkActor> wireActor(vtkPolyData* surface);

/// The edge length of equilateral triangles as large as the mesh's mean triangle.
[[nodiscard]] double meanEdge(vtkPolyData* mesh);

/// Soft light from above the viewer's shoulder.
void addLights(vtkRenderer* renderer);

/// The same with more of it from the viewer: what faces the floor stays light enough for lines.
void addInspectionLights(vtkRenderer* renderer);

/// Looks from ViewFrom, closer than ResetCamera(): the surface just fits a window of this aspect
/// (width over height) with a margin, a fraction of the height.
void aimCamera(vtkRenderer* renderer, vtkPolyData* surface, double aspect, double margin);

/// As aimCamera(), from where the camera looks now.
void fitCamera(vtkRenderer* renderer, vtkPolyData* surface, double aspect, double margin);
}

#endif
