// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The one file of this module that includes CGAL.
#include "DegenerateFaces.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Surface_mesh.h>

namespace stipple
{
bool removeDegenerateFaces(
  TriangleSurface& surface, std::vector<int>& sourcePoint, std::vector<int>& sourceCell)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  Mesh mesh;
  auto pointSource = mesh.add_property_map<Mesh::Vertex_index, int>("v:source", 0).first;
  auto cellSource = mesh.add_property_map<Mesh::Face_index, int>("f:source", 0).first;
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    const Vec3& x = surface.points[p];
    pointSource[mesh.add_vertex({ x[0], x[1], x[2] })] = sourcePoint[p];
  }
  for (std::size_t f = 0; f < surface.triangles.size(); ++f)
  {
    const Triangle& t = surface.triangles[f];
    const auto face =
      mesh.add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]), Mesh::Vertex_index(t[2]));
    if (face == Mesh::null_face())
    {
      return false;
    }
    cellSource[face] = sourceCell[f];
  }
  const bool clean = CGAL::Polygon_mesh_processing::remove_degenerate_faces(mesh);
  mesh.collect_garbage();
  surface = {};
  sourcePoint.clear();
  sourceCell.clear();
  for (const auto v : mesh.vertices())
  {
    const auto& p = mesh.point(v);
    surface.points.emplace_back(p.x(), p.y(), p.z());
    sourcePoint.push_back(pointSource[v]);
  }
  for (const auto f : mesh.faces())
  {
    Triangle t;
    int k = 0;
    for (const auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
    {
      t[k++] = static_cast<int>(v);
    }
    surface.triangles.push_back(t);
    sourceCell.push_back(cellSource[f]);
  }
  return clean;
}
}
