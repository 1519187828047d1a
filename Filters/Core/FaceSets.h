// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Triangles that hang together.
#ifndef stipple_FaceSets_h
#define stipple_FaceSets_h

#include "TriangleSurface.h"

namespace stipple
{
/// Sets of triangles that are connected across some edges, numbered by their first triangle.
struct FaceSets
{
  ElementArray<Face, int> of;
  int number = 0;

  std::vector<std::vector<Face>> faces() const
  {
    std::vector<std::vector<Face>> faces(this->number);
    for (const Face f : this->of.ids())
    {
      faces[this->of[f]].push_back(f);
    }
    return faces;
  }

  /// isOpen(h) tells whether the triangles on both sides of an inner edge hang together.
  template <typename IsOpen>
  FaceSets(const TriangleSurface& surface, const IsOpen& isOpen)
    : of(surface.triangles.size(), -1)
  {
    std::vector<Face> front;
    for (const Face start : surface.faces())
    {
      if (this->of[start] >= 0)
      {
        continue;
      }
      this->of[start] = this->number;
      front = { start };
      while (!front.empty())
      {
        const Face f = front.back();
        front.pop_back();
        for (const Halfedge h : halfedgesOf(f))
        {
          const Halfedge twin = surface.twin[h];
          if (twin.valid() && isOpen(h) && this->of[faceOf(twin)] < 0)
          {
            this->of[faceOf(twin)] = this->number;
            front.push_back(faceOf(twin));
          }
        }
      }
      ++this->number;
    }
  }
};
}

#endif
