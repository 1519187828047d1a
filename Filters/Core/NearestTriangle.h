// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The nearest of many triangles, by a tree of boxes: the same one whatever the order of triangles
// and the number of threads, which VTK's locators do not promise.
#ifndef stipple_NearestTriangle_h
#define stipple_NearestTriangle_h

#include "StippleFiltersCoreModule.h"
#include "TriangleSurface.h"

#include <memory>

namespace stipple
{
/// The triangles of a surface, any soup of them, to be asked for the nearest one. Borrows the
/// surface, which has a triangle.
class STIPPLEFILTERSCORE_EXPORT NearestTriangle
{
public:
  explicit NearestTriangle(const TriangleSurface& surface);
  ~NearestTriangle();

  struct Hit
  {
    int face = -1;
    double squaredDistance = 0;
  };
  /// The nearest triangle, found sooner if `hint` is near; -1: none known. Of those that are as
  /// near, beside an edge or about a vertex, the one that the place is highest above, whatever
  /// their order. With `enough`, 0 or more, any triangle may be the answer whose squared distance
  /// is no larger, which is found sooner.
  Hit find(const Vec3& p, int hint = -1, double enough = -1.) const;
  /// Squared distance of a place from one triangle.
  double squaredDistance(const Vec3& p, int face) const;
  const TriangleSurface& surface() const { return this->Surface; }

private:
  bool isBelow(const Vec3& p, int face, int other) const;

  struct Node;
  struct Tree;
  const TriangleSurface& Surface;
  std::unique_ptr<Tree> Boxes;
};
}

#endif
