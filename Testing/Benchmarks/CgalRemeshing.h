// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What users would call instead: CGAL's isotropic_remeshing, with five iterations, at an edge
// length that makes about the number of points asked for. It takes no number, so the length is
// searched for, which is not timed.
#ifndef stipple_CgalRemeshing_h
#define stipple_CgalRemeshing_h

#include "TriangleSurface.h"

#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cmath>
#include <vector>

namespace benchmarks
{
class CgalRemeshing
{
public:
  CgalRemeshing(vtkPolyData* triangles, double numberOfPoints)
  {
    namespace PMP = CGAL::Polygon_mesh_processing;
    std::vector<Mesh::Point> points;
    double p[3];
    for (vtkIdType i = 0; i < triangles->GetNumberOfPoints(); ++i)
    {
      triangles->GetPoint(i, p);
      points.emplace_back(p[0], p[1], p[2]);
    }
    std::vector<std::array<std::size_t, 3>> faces;
    vtkNew<vtkIdList> cell;
    for (vtkIdType c = 0; c < triangles->GetNumberOfPolys(); ++c)
    {
      triangles->GetCellPoints(c, cell);
      const auto id = [&](int k) { return static_cast<std::size_t>(cell->GetId(k)); };
      faces.push_back({ id(0), id(1), id(2) });
    }
    // Files hold soups: CGAL's own way to a surface, as its users go it; not timed.
    PMP::repair_polygon_soup(points, faces);
    PMP::orient_polygon_soup(points, faces);
    PMP::polygon_soup_to_polygon_mesh(points, faces, this->Input);
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
  double run() const { return static_cast<double>(this->remeshed().number_of_vertices()); }

  /// What run() makes.
  stipple::TriangleSurface surface() const
  {
    Mesh mesh = this->remeshed();
    mesh.collect_garbage();
    stipple::TriangleSurface surface;
    for (const auto v : mesh.vertices())
    {
      const auto& p = mesh.point(v);
      surface.points.emplace_back(p.x(), p.y(), p.z());
    }
    for (const auto f : mesh.faces())
    {
      stipple::Triangle triangle;
      int k = 0;
      for (const auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      {
        triangle[k++] = static_cast<int>(v);
      }
      surface.triangles.push_back(triangle);
    }
    return surface;
  }

private:
  using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
  Mesh remeshed() const
  {
    Mesh mesh = this->Input;
    CGAL::Polygon_mesh_processing::isotropic_remeshing(faces(mesh), this->EdgeLength, mesh,
      CGAL::Polygon_mesh_processing::parameters::number_of_iterations(5));
    return mesh;
  }

  Mesh Input;
  double EdgeLength = 0;
};
}

#endif
