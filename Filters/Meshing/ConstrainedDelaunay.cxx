// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ConstrainedDelaunay.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <numeric>

namespace stipple
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using FaceInfo = CGAL::Triangulation_face_base_with_info_2<char, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel, FaceInfo>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Delaunay = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure,
  CGAL::No_constraint_intersection_tag>;

/// Walks the faces that the open segment from a to b passes: the first point on it, or constraint
/// across it.
bool findObstacle(const Delaunay& cdt, Delaunay::Vertex_handle a, Delaunay::Vertex_handle b,
  Delaunay::Vertex_handle& on, Delaunay::Edge& across)
{
  auto walk = cdt.line_walk(a->point(), b->point(), Delaunay::Face_handle());
  // Only faces that touch the open segment matter; a line walk starts and stops at its end points'
  // faces.
  const Kernel::Segment_2 segment(a->point(), b->point());
  const auto start = walk;
  if (start == nullptr)
  {
    return false;
  }
  do
  {
    const Delaunay::Face_handle f = walk;
    if (cdt.is_infinite(f))
    {
      ++walk;
      continue;
    }
    for (int i = 0; i < 3; ++i)
    {
      const auto v = f->vertex(i);
      if (v != a && v != b && segment.has_on(v->point()))
      {
        on = v;
        return true;
      }
    }
    for (int i = 0; i < 3; ++i)
    {
      const auto p = f->vertex(Delaunay::cw(i));
      const auto q = f->vertex(Delaunay::ccw(i));
      if (f->is_constrained(i) && p != a && p != b && q != a && q != b &&
        CGAL::do_intersect(segment, Kernel::Segment_2(p->point(), q->point())))
      {
        across = Delaunay::Edge(f, i);
        return true;
      }
    }
    if (f->has_vertex(b))
    {
      break;
    }
    ++walk;
  } while (walk != start);
  return false;
}
}

DelaunayConflict constrainedDelaunay(const std::vector<Vec2>& points,
  const std::vector<std::array<int, 2>>& segments, std::vector<Triangle>& triangles,
  const Stop& stop)
{
  using Kind = DelaunayConflict::Kind;
  triangles.clear();
  const int n = static_cast<int>(points.size());
  std::vector<Delaunay::Point> position(n);
  for (int i = 0; i < n; ++i)
  {
    position[i] = Delaunay::Point(points[i].x(), points[i].y());
  }
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  const auto map = CGAL::make_property_map(position);
  CGAL::spatial_sort(
    order.begin(), order.end(), CGAL::Spatial_sort_traits_adapter_2<Kernel, decltype(map)>(map));

  Delaunay cdt;
  std::vector<Delaunay::Vertex_handle> vertex(n);
  Delaunay::Face_handle hint;
  for (const std::size_t o : order)
  {
    if (isAsked(stop))
    {
      return {};
    }
    const int i = static_cast<int>(o);
    const std::size_t before = cdt.number_of_vertices();
    const auto v = cdt.insert(position[i], hint);
    if (cdt.number_of_vertices() == before)
    {
      return { Kind::Duplicate, std::max(i, v->info()), std::min(i, v->info()) };
    }
    v->info() = i;
    vertex[i] = v;
    hint = v->face();
  }
  if (cdt.dimension() < 2)
  {
    return { Kind::Degenerate, -1, -1 };
  }
  for (std::size_t s = 0; s < segments.size(); ++s)
  {
    const auto a = vertex[segments[s][0]];
    const auto b = vertex[segments[s][1]];
    Delaunay::Face_handle f;
    int i;
    if (!cdt.is_edge(a, b, f, i))
    {
      Delaunay::Vertex_handle on;
      Delaunay::Edge across;
      if (findObstacle(cdt, a, b, on, across))
      {
        if (on != nullptr)
        {
          return { Kind::OnSegment, on->info(), static_cast<int>(s) };
        }
        const int p = across.first->vertex(Delaunay::cw(across.second))->info();
        const int q = across.first->vertex(Delaunay::ccw(across.second))->info();
        for (std::size_t r = 0; r < s; ++r)
        {
          if ((segments[r][0] == p && segments[r][1] == q) ||
            (segments[r][0] == q && segments[r][1] == p))
          {
            return { Kind::Crossing, static_cast<int>(s), static_cast<int>(r) };
          }
        }
      }
    }
    cdt.insert_constraint(a, b);
  }

  // Outside is what the infinite face reaches without crossing a constraint.
  for (auto f = cdt.all_faces_begin(); f != cdt.all_faces_end(); ++f)
  {
    f->info() = 0;
  }
  std::vector<Delaunay::Face_handle> stack = { cdt.infinite_face() };
  cdt.infinite_face()->info() = 1;
  while (!stack.empty())
  {
    const auto f = stack.back();
    stack.pop_back();
    for (int i = 0; i < 3; ++i)
    {
      const auto g = f->neighbor(i);
      if (!g->info() && !f->is_constrained(i))
      {
        g->info() = 1;
        stack.push_back(g);
      }
    }
  }
  for (auto f = cdt.finite_faces_begin(); f != cdt.finite_faces_end(); ++f)
  {
    if (!f->info())
    {
      triangles.push_back({ f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info() });
    }
  }
  return {};
}
}
