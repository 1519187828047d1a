// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Places on the input surface under the pointer, and paths along its edges.
#ifndef stipple_SurfacePicker_h
#define stipple_SurfacePicker_h

#include "CellLocator.h"
#include "Geometry.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <memory>
#include <vector>

class vtkPolyData;
class vtkRenderer;

namespace stipple
{
struct PickedPlace
{
  Vec3 position = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();                  ///< of the face
  std::array<vtkIdType, 2> edge = { { 0, 0 } }; ///< the face's nearest one, smaller point id first
  vtkIdType point = 0;                          ///< the face's nearest one
};

class SurfacePicker
{
public:
  explicit SurfacePicker(vtkPolyData* input);
  ~SurfacePicker();
  SurfacePicker(const SurfacePicker&) = delete;
  SurfacePicker& operator=(const SurfacePicker&) = delete;

  /// Those at the very same place are one.
  [[nodiscard]] vtkIdType numberOfPoints() const { return this->NumberOfPoints; }

  /// What the ray through a window's pixel hits first.
  [[nodiscard]] bool pick(vtkRenderer* renderer, double x, double y, PickedPlace& place) const;

  /// The place of the surface next to one off it.
  [[nodiscard]] PickedPlace nearest(const Vec3& position) const;

  /// Edges of the shortest way between two points of the input; empty if there is none.
  [[nodiscard]] std::vector<std::array<vtkIdType, 2>> shortestPath(
    vtkIdType from, vtkIdType to) const;

private:
  /// What is told of a place on a face.
  [[nodiscard]] PickedPlace placeOn(vtkIdType cell, const Vec3& position) const;

  vtkSmartPointer<vtkPolyData> Input;
  std::unique_ptr<CellLocator> Locator;
  vtkIdType NumberOfPoints = 0;
};
}

#endif
