// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// StippleMeshFolds MESH.off REFERENCE.off
//
// Prints as JSON how many pairs of triangles of each mesh intersect, and how many triangles of MESH
// are flipped: turned away from the triangle of REFERENCE that is nearest to their centroid. By
// CGAL alone.
#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <cstdio>
#include <iterator>
#include <utility>
#include <vector>

namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
namespace PMP = CGAL::Polygon_mesh_processing;

std::size_t intersections(const Mesh& mesh)
{
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> pairs;
  PMP::self_intersections(mesh, std::back_inserter(pairs));
  return pairs.size();
}
}

int main(int argc, char* argv[])
{
  Mesh mesh;
  Mesh reference;
  if (argc != 3 || !PMP::IO::read_polygon_mesh(argv[1], mesh) ||
    !PMP::IO::read_polygon_mesh(argv[2], reference))
  {
    std::fprintf(stderr, "usage: StippleMeshFolds MESH.off REFERENCE.off (two triangle meshes)\n");
    return 2;
  }
  const Tree tree(faces(reference).begin(), faces(reference).end(), reference);
  std::size_t flipped = 0;
  for (const Mesh::Face_index f : mesh.faces())
  {
    Kernel::Point_3 corner[3];
    int k = 0;
    for (const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
    {
      corner[k++] = mesh.point(v);
    }
    const auto nearest =
      tree.closest_point_and_primitive(CGAL::centroid(corner[0], corner[1], corner[2])).second;
    flipped +=
      PMP::compute_face_normal(f, mesh) * PMP::compute_face_normal(nearest, reference) < 0 ? 1 : 0;
  }
  std::printf(
    "{\"self_intersections\": %zu, \"reference_self_intersections\": %zu, \"flipped\": %zu}\n",
    intersections(mesh), intersections(reference), flipped);
  return 0;
}
