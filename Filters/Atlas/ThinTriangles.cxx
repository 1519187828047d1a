// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ThinTriangles.h"

#include <algorithm>
#include <deque>
#include <iterator>

namespace stipple
{
namespace
{
class ThinTriangles
{
public:
  explicit ThinTriangles(TriangleSurface& surface)
    : Surface(surface)
    , Rounding(1e-7 * surface.boundingBoxDiagonal())
    , Dropped(surface.triangles.size(), 0)
  {
  }

  /// Number of thin triangles; they are removed as far as can be.
  int run()
  {
    for (const Face f : this->Surface.faces())
    {
      if (this->isThin(f))
      {
        this->Queue.push_back(f);
      }
    }
    const int found = static_cast<int>(this->Queue.size());
    if (found == 0)
    {
      return 0;
    }
    this->First = this->Surface.vertexHalfedges();
    // Swaps among many thin triangles along one line shorten edges, so that they come to an end;
    // this bound is for those that rounding sends in circles.
    for (std::size_t left = 100 * this->Queue.size(); left > 0 && !this->Queue.empty(); --left)
    {
      const Face f = this->Queue.front();
      this->Queue.pop_front();
      if (!this->Dropped[f] && this->isThin(f))
      {
        this->remove(f);
      }
    }
    return found;
  }

  bool isDropped(Face f) const { return this->Dropped[f]; }

private:
  double length(Halfedge h) const { return this->Surface.edgeLength(h); }

  Halfedge longestEdge(Face f) const
  {
    Halfedge longest = halfedgeOf(f, 0);
    for (const Halfedge h : halfedgesOf(f))
    {
      longest = this->length(h) > this->length(longest) ? h : longest;
    }
    return longest;
  }

  /// The height up to which a triangle with this longest edge is thin.
  double tolerance(double longest) const
  {
    return std::max(1e-6 * longest, std::min(1e-3 * longest, this->Rounding));
  }

  bool isThin(Face f) const
  {
    const double longest = this->length(this->longestEdge(f));
    return 2 * this->Surface.faceArea(f) <= longest * this->tolerance(longest);
  }

  bool onBoundary(Vertex p) const { return this->Surface.isBoundary(this->First[p]); }

  void remove(Face f)
  {
    const Halfedge longest = this->longestEdge(f);
    Halfedge shortest = nextHalfedge(longest);
    if (this->length(previousHalfedge(longest)) < this->length(shortest))
    {
      shortest = previousHalfedge(longest);
    }
    if (this->length(shortest) <= 4 * this->tolerance(this->length(longest)))
    {
      this->collapse(shortest);
    }
    else if (!this->Surface.isBoundary(longest))
    {
      this->swap(longest);
    }
    else
    {
      this->dropAtBoundary(longest);
    }
  }

  /// Points joined to p by an edge, ascending; only their number and identity matter.
  std::vector<Vertex> neighbours(Vertex p) const
  {
    std::vector<Vertex> found;
    Halfedge h = this->First[p];
    while (true)
    {
      found.push_back(this->Surface.head(h));
      const Halfedge previous = previousHalfedge(h);
      h = this->Surface.twin[previous];
      if (!h.valid())
      {
        found.push_back(this->Surface.tail(previous));
      }
      if (!h.valid() || h == this->First[p])
      {
        break;
      }
    }
    std::sort(found.begin(), found.end());
    return found;
  }

  void link(Halfedge h, Halfedge t)
  {
    if (h.valid())
    {
      this->Surface.twin[h] = t;
    }
    if (t.valid())
    {
      this->Surface.twin[t] = h;
    }
  }

  /// Finds the halfedges that leave the corners of triangles anew.
  void refreshFirst(const std::vector<Face>& faces)
  {
    for (const Face f : faces)
    {
      if (this->Dropped[f])
      {
        continue;
      }
      for (const Halfedge h : halfedgesOf(f))
      {
        Halfedge first = h; // clockwise as far as can be
        while (!this->Surface.isBoundary(first))
        {
          first = nextHalfedge(this->Surface.twin[first]);
          if (first == h)
          {
            break;
          }
        }
        this->First[this->Surface.tail(h)] = first;
      }
    }
  }

  /// Merges the ends of an edge into one; both triangles beside it go.
  void collapse(Halfedge h)
  {
    TriangleSurface& s = this->Surface;
    const Halfedge twin = s.twin[h];
    Vertex kept = s.tail(h);
    Vertex gone = s.head(h);
    if (twin.valid() && this->onBoundary(kept) && this->onBoundary(gone))
    {
      return; // a bridge
    }
    if (this->onBoundary(gone) && !this->onBoundary(kept))
    {
      std::swap(kept, gone);
    }
    const std::vector<Vertex> a = this->neighbours(kept);
    const std::vector<Vertex> b = this->neighbours(gone);
    std::vector<Vertex> common;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
    // The link condition; a part of few triangles would fold onto itself.
    if (common.size() != (twin.valid() ? 2U : 1U) || a.size() + b.size() < common.size() + 5)
    {
      return;
    }
    std::vector<Halfedge> around;
    Halfedge g = this->First[gone];
    do
    {
      around.push_back(g);
      g = s.twin[previousHalfedge(g)];
    } while (g.valid() && g != this->First[gone]);
    std::vector<Face> faces;
    for (const Halfedge corner : around)
    {
      s.triangles[faceOf(corner).index()][cornerOf(corner)] = kept.index();
      faces.push_back(faceOf(corner));
    }
    for (const Halfedge side : { h, twin })
    {
      if (side.valid())
      {
        this->Dropped[faceOf(side)] = 1;
        const Halfedge left = s.twin[nextHalfedge(side)];
        const Halfedge right = s.twin[previousHalfedge(side)];
        this->link(left, right);
        addFaces({ left, right }, faces);
      }
    }
    this->refreshFirst(faces);
    this->Queue.insert(this->Queue.end(), faces.begin(), faces.end());
  }

  /// Joins the opposite corners of the two triangles beside an edge instead of its ends.
  void swap(Halfedge h)
  {
    TriangleSurface& s = this->Surface;
    const Halfedge g = s.twin[h];
    const Vertex p = s.tail(h);
    const Vertex q = s.head(h);
    const Vertex a = s.tail(previousHalfedge(h));
    const Vertex d = s.tail(previousHalfedge(g));
    const std::vector<Vertex> beside = this->neighbours(a);
    if (a == d || std::binary_search(beside.begin(), beside.end(), d))
    {
      return;
    }
    const Halfedge qa = s.twin[nextHalfedge(h)];
    const Halfedge ap = s.twin[previousHalfedge(h)];
    const Halfedge pd = s.twin[nextHalfedge(g)];
    const Halfedge dq = s.twin[previousHalfedge(g)];
    const Face f = faceOf(h);
    const Face e = faceOf(g);
    s.triangles[f.index()] = { a.index(), p.index(), d.index() };
    s.triangles[e.index()] = { d.index(), q.index(), a.index() };
    this->link(halfedgeOf(f, 0), ap);
    this->link(halfedgeOf(f, 1), pd);
    this->link(halfedgeOf(f, 2), halfedgeOf(e, 2));
    this->link(halfedgeOf(e, 0), dq);
    this->link(halfedgeOf(e, 1), qa);
    this->refreshFirst({ f, e });
    this->Queue.push_back(f);
    this->Queue.push_back(e);
  }

  /// Drops a triangle whose longest edge is on the boundary.
  void dropAtBoundary(Halfedge h)
  {
    TriangleSurface& s = this->Surface;
    const Halfedge next = s.twin[nextHalfedge(h)];
    const Halfedge previous = s.twin[previousHalfedge(h)];
    if (next.valid() && previous.valid() && this->onBoundary(s.tail(previousHalfedge(h))))
    {
      return; // what is left would hang together in a point
    }
    this->Dropped[faceOf(h)] = 1;
    this->link(next, {});
    this->link(previous, {});
    std::vector<Face> faces;
    addFaces({ next, previous }, faces);
    this->refreshFirst(faces);
  }

  static void addFaces(std::initializer_list<Halfedge> sides, std::vector<Face>& faces)
  {
    for (const Halfedge side : sides)
    {
      if (side.valid())
      {
        faces.push_back(faceOf(side));
      }
    }
  }

  TriangleSurface& Surface;
  double Rounding;
  ElementArray<Face, char> Dropped;
  ElementArray<Vertex, Halfedge> First; // a halfedge that leaves each point, as vertexHalfedges()
                                        // has it
  std::deque<Face> Queue;
};
}

int removeThinTriangles(TriangleSurface& surface, std::vector<int>& sourceCell)
{
  ThinTriangles thin(surface);
  const int found = thin.run();
  if (found == 0)
  {
    return 0;
  }
  int n = 0;
  for (const Face f : surface.faces())
  {
    if (!thin.isDropped(f))
    {
      surface.triangles[n] = surface.triangle(f);
      sourceCell[n++] = int(sourceCell[f.index()]);
    }
  }
  surface.triangles.resize(n);
  sourceCell.resize(n);
  surface.connect();
  return found;
}
}
