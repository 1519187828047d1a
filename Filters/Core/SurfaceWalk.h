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
  /// wall, if not empty, marks halfedges (both of an edge) that no walk crosses.
  explicit SurfaceWalk(const TriangleSurface& surface, const std::vector<char>& wall = {});

  /// Goes from a place along a vector of space: the vector is projected on the face and unfolded at
  /// every edge that is crossed. Ends early at the surface's boundary, unless told to pass at a
  /// wall, and where it comes back to a face, which no shortest way does.
  SurfacePlace walk(const SurfacePlace& from, const Vec3& vector, bool passWalls = false) const;

  /// Unit normal of a face; zero if it is degenerate.
  const Vec3& normal(int face) const { return this->Faces[face].normal; }
  /// TriangleSurface::position()
  Vec3 position(const SurfacePlace& place) const
  {
    const auto& p = this->Faces[place.face].point;
    return place.bary[0] * p[0] + place.bary[1] * p[1] + place.bary[2] * p[2];
  }
  /// Has a face fetched from memory that will soon be walked on.
  void prefetch(int face) const
  {
    const char* data = reinterpret_cast<const char*>(&this->Faces[face]);
    __builtin_prefetch(data);
    __builtin_prefetch(data + 64);
    __builtin_prefetch(data + sizeof(FaceData) - 1);
  }

private:
  /// All that a walk asks of a triangle: it reads those that it meets from one place each, which
  /// takes most of its time.
  struct FaceData
  {
    std::array<Vec3, 3> point;
    Vec3 normal;
    std::array<Vec3, 2> gradient; ///< of the first two barycentric coordinates
    std::array<int, 3> twin;
    std::array<char, 3> wall;
  };
  std::vector<FaceData> Faces;
};
}

#endif
