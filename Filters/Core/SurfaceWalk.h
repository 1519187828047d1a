// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Straight walks over the triangles of a surface: how a vertex moves without ever leaving it. A
// walk needs no chart, and crosses seams like any other edge.
#ifndef stipple_SurfaceWalk_h
#define stipple_SurfaceWalk_h

#include "StippleFiltersCoreModule.h"
#include "TriangleSurface.h"

namespace stipple
{
/// A place on a surface.
struct SurfacePlace
{
  int face = -1;
  Vec3 bary = Vec3::Zero();
};

class STIPPLEFILTERSCORE_EXPORT SurfaceWalk
{
public:
  /// Keeps a reference to the surface. wall, if not empty, marks halfedges (both of an edge) that
  /// no walk crosses.
  explicit SurfaceWalk(const TriangleSurface& surface, std::vector<char> wall = {});

  /// Goes from a place along a vector of space: the vector is projected on the face and unfolded at
  /// every edge that is crossed. Ends early at the surface's boundary and, unless told to pass, at
  /// a wall.
  SurfacePlace walk(const SurfacePlace& from, const Vec3& vector, bool passWalls = false) const;

  /// Unit normal of a face; zero if it is degenerate.
  const Vec3& normal(int face) const { return this->Normal[face]; }

private:
  const TriangleSurface& Surface;
  std::vector<char> Wall;
  std::vector<Vec3> Normal;
  std::vector<std::array<Vec3, 2>> Gradient; // of the barycentric coordinates 0 and 1
};
}

#endif
