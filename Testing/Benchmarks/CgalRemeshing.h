// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What users would call instead: CGAL's isotropic_remeshing, with five iterations, at an edge
// length that makes about the number of points asked for. It takes no number, so the length is
// searched for, which is not timed.
#ifndef stipple_CgalRemeshing_h
#define stipple_CgalRemeshing_h

#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>

namespace benchmarks
{
class CgalRemeshing
{
public:
  CgalRemeshing(vtkPolyData* triangles, double numberOfPoints)
  {
    double p[3];
    for (vtkIdType i = 0; i < triangles->GetNumberOfPoints(); ++i)
    {
      triangles->GetPoint(i, p);
      this->Input.add_vertex({ p[0], p[1], p[2] });
    }
    vtkNew<vtkIdList> cell;
    for (vtkIdType c = 0; c < triangles->GetNumberOfPolys(); ++c)
    {
      triangles->GetCellPoints(c, cell);
      const auto v = [&](int k) { return Mesh::Vertex_index(cell->GetId(k)); };
      this->Input.add_face(v(0), v(1), v(2));
    }
    const double area = CGAL::to_double(CGAL::Polygon_mesh_processing::area(this->Input));
    // That of equilateral triangles; then as long as the number is off by more than 1 %.
    this->EdgeLength = std::sqrt(area / (2 * numberOfPoints) * 4 / std::sqrt(3.));
    for (int attempt = 0; attempt < 5; ++attempt)
    {
      const double points = this->run();
      if (std::abs(points - numberOfPoints) <= 0.01 * numberOfPoints)
      {
        break;
      }
      this->EdgeLength *= std::sqrt(points / numberOfPoints);
    }
  }

  /// Remeshes a copy; returns its number of points.
  double run() const
  {
    Mesh mesh = this->Input;
    CGAL::Polygon_mesh_processing::isotropic_remeshing(faces(mesh), this->EdgeLength, mesh,
      CGAL::Polygon_mesh_processing::parameters::number_of_iterations(5));
    return static_cast<double>(mesh.number_of_vertices());
  }

private:
  using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
  Mesh Input;
  double EdgeLength = 0;
};
}

#endif
