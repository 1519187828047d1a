// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Closed and open surfaces with known topology and curvature, for the kernels' tests.
#ifndef stipple_Shapes_h
#define stipple_Shapes_h

#include "CutSurface.h"
#include "TriangleIntersections.h"

#include "vtkSmartPointer.h"

#include <functional>
#include <ostream>

class vtkPolyData;

namespace shapes
{
/// A torus about the z axis with nu x nv quads, each cut in two.
stipple::TriangleSurface torus(double ringRadius, double crossRadius, int nu, int nv);
/// A sphere from an icosahedron, refined 1 to 4 some times.
stipple::TriangleSurface sphere(double radius, int refinements);
/// The unit cube, every face a grid of n x n quads cut in two.
stipple::TriangleSurface cube(int n);
/// A closed cylinder about the z axis: n sides, m rings, capped by fans.
stipple::TriangleSurface cylinder(double radius, double height, int n, int m);
/// A closed cone about the z axis: n sides, m rings of its mantle, capped by a fan.
stipple::TriangleSurface cone(double radius, double height, int n, int m);
/// A unit sphere with a long horn along the x axis, refined 1 to 4 some times.
stipple::TriangleSurface hornedSphere(int refinements);
/// A slab of unit cubes with nx x ny holes, of genus nx ny; every square is a grid of m x m quads.
stipple::TriangleSurface perforatedSlab(int nx, int ny, int m);
/// A flat grid of n x n squares over [0, 1]^2, each cut along the same diagonal; not connected.
stipple::TriangleSurface grid(int n, double height = 0.);
/// The saddle z = x y over [-1, 1]^2 on an n x n grid.
stipple::TriangleSurface saddle(int n);

/// A shape, told by its name.
struct Named
{
  const char* name;
  stipple::TriangleSurface surface;
  /// Or GoogleTest puts the bytes into the test's name.
  friend std::ostream& operator<<(std::ostream& stream, const Named& shape)
  {
    return stream << shape.name;
  }
};

/// To be cut into charts; every triangle comes from the cell of its number.
stipple::CutSurface cutSurface(const stipple::TriangleSurface& surface);

vtkSmartPointer<vtkPolyData> toPolyData(const stipple::TriangleSurface& surface);

/// Says where a surface, which must outlive it, passes through itself.
inline std::function<std::vector<stipple::Box>()> intersectionsOf(
  const stipple::TriangleSurface& surface)
{
  return [&surface] {
    return stipple::placesOfIntersections(surface.points, surface.triangles)
      .value_or(std::vector<stipple::Box>());
  };
}
}

#endif
