// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Elements about others. All lists are ascending, each element once.
#ifndef stipple_MeshRegion_h
#define stipple_MeshRegion_h

#include "OptimizedMesh.h"

#include <iterator>

namespace stipple
{
inline std::vector<Vertex> cornersOf(const OptimizedMesh& mesh, const std::vector<Face>& faces)
{
  std::vector<Vertex> result;
  for (const Face f : faces)
  {
    const auto corners = mesh.corners(f);
    result.insert(result.end(), corners.begin(), corners.end());
  }
  makeUnique(result);
  return result;
}

inline std::vector<Face> facesAbout(const OptimizedMesh& mesh, const std::vector<Vertex>& vertices)
{
  std::vector<Face> result;
  for (const Vertex v : vertices)
  {
    mesh.forEachFace(v, [&](Face f) { result.push_back(f); });
  }
  makeUnique(result);
  return result;
}

inline std::vector<Edge> edgesAbout(const OptimizedMesh& mesh, const std::vector<Vertex>& vertices)
{
  std::vector<Edge> result;
  for (const Vertex v : vertices)
  {
    mesh.forEachHalfedge(v, [&](Halfedge h) { result.push_back(mesh.edge(h)); });
  }
  makeUnique(result);
  return result;
}

/// Vertices and so many rings of neighbours about them, of which only those that isWanted(v) are
/// taken and gone on from.
template <typename IsWanted>
std::vector<Vertex> withRings(
  const OptimizedMesh& mesh, std::vector<Vertex> vertices, int rings, const IsWanted& isWanted)
{
  makeUnique(vertices);
  for (int ring = 0; ring < rings; ++ring)
  {
    const std::vector<Vertex> inner = vertices;
    for (const Vertex v : inner)
    {
      mesh.forEachNeighbour(v, [&](Vertex u) {
        if (isWanted(u))
        {
          vertices.push_back(u);
        }
      });
    }
    makeUnique(vertices);
  }
  return vertices;
}
inline std::vector<Vertex> withRings(
  const OptimizedMesh& mesh, std::vector<Vertex> vertices, int rings)
{
  return withRings(mesh, std::move(vertices), rings, [](Vertex) { return true; });
}

/// Those of which isWanted() is true.
template <typename Id, typename IsWanted>
std::vector<Id> filtered(const std::vector<Id>& ids, const IsWanted& isWanted)
{
  std::vector<Id> result;
  std::copy_if(ids.begin(), ids.end(), std::back_inserter(result), isWanted);
  return result;
}
}

#endif
