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
    for (int f = 0; f < this->Surface.numberOfFaces(); ++f)
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
      const int f = this->Queue.front();
      this->Queue.pop_front();
      if (!this->Dropped[f] && this->isThin(f))
      {
        this->remove(f);
      }
    }
    return found;
  }

  bool isDropped(int f) const { return this->Dropped[f]; }

private:
  double length(int h) const
  {
    return (
      this->Surface.points[this->Surface.head(h)] - this->Surface.points[this->Surface.tail(h)])
      .norm();
  }

  int longestEdge(int f) const
  {
    int longest = 3 * f;
    for (int h = 3 * f + 1; h < 3 * f + 3; ++h)
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

  bool isThin(int f) const
  {
    const double longest = this->length(this->longestEdge(f));
    return 2 * this->Surface.faceArea(f) <= longest * this->tolerance(longest);
  }

  bool onBoundary(int p) const { return this->Surface.twin[this->First[p]] < 0; }

  void remove(int f)
  {
    const int longest = this->longestEdge(f);
    int shortest = nextHalfedge(longest);
    if (this->length(previousHalfedge(longest)) < this->length(shortest))
    {
      shortest = previousHalfedge(longest);
    }
    if (this->length(shortest) <= 4 * this->tolerance(this->length(longest)))
    {
      this->collapse(shortest);
    }
    else if (this->Surface.twin[longest] >= 0)
    {
      this->swap(longest);
    }
    else
    {
      this->dropAtBoundary(longest);
    }
  }

  /// Points joined to p by an edge, ascending; only their number and identity matter.
  std::vector<int> neighbours(int p) const
  {
    std::vector<int> found;
    int h = this->First[p];
    while (true)
    {
      found.push_back(this->Surface.head(h));
      const int previous = previousHalfedge(h);
      h = this->Surface.twin[previous];
      if (h < 0)
      {
        found.push_back(this->Surface.tail(previous));
      }
      if (h < 0 || h == this->First[p])
      {
        break;
      }
    }
    std::sort(found.begin(), found.end());
    return found;
  }

  void link(int h, int t)
  {
    if (h >= 0)
    {
      this->Surface.twin[h] = t;
    }
    if (t >= 0)
    {
      this->Surface.twin[t] = h;
    }
  }

  /// Finds the halfedges that leave the corners of triangles anew.
  void refreshFirst(const std::vector<int>& faces)
  {
    for (int f : faces)
    {
      for (int h = 3 * f; h < 3 * f + 3 && !this->Dropped[f]; ++h)
      {
        int first = h; // clockwise as far as can be
        while (this->Surface.twin[first] >= 0)
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
  void collapse(int h)
  {
    TriangleSurface& s = this->Surface;
    const int twin = s.twin[h];
    int kept = s.tail(h);
    int gone = s.head(h);
    if (twin >= 0 && this->onBoundary(kept) && this->onBoundary(gone))
    {
      return; // a bridge
    }
    if (this->onBoundary(gone) && !this->onBoundary(kept))
    {
      std::swap(kept, gone);
    }
    const std::vector<int> a = this->neighbours(kept);
    const std::vector<int> b = this->neighbours(gone);
    std::vector<int> common;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
    // The link condition; a part of few triangles would fold onto itself.
    if (common.size() != (twin >= 0 ? 2U : 1U) || a.size() + b.size() < common.size() + 5)
    {
      return;
    }
    std::vector<int> around;
    int g = this->First[gone];
    do
    {
      around.push_back(g);
      g = s.twin[previousHalfedge(g)];
    } while (g >= 0 && g != this->First[gone]);
    std::vector<int> faces;
    for (int corner : around)
    {
      s.triangles[corner / 3][corner % 3] = kept;
      faces.push_back(corner / 3);
    }
    for (int side : { h, twin })
    {
      if (side >= 0)
      {
        this->Dropped[side / 3] = 1;
        const int left = s.twin[nextHalfedge(side)];
        const int right = s.twin[previousHalfedge(side)];
        this->link(left, right);
        for (int rest : { left, right })
        {
          if (rest >= 0)
          {
            faces.push_back(rest / 3);
          }
        }
      }
    }
    this->refreshFirst(faces);
    this->Queue.insert(this->Queue.end(), faces.begin(), faces.end());
  }

  /// Joins the opposite corners of the two triangles beside an edge instead of its ends.
  void swap(int h)
  {
    TriangleSurface& s = this->Surface;
    const int g = s.twin[h];
    const int p = s.tail(h);
    const int q = s.head(h);
    const int a = s.tail(previousHalfedge(h));
    const int d = s.tail(previousHalfedge(g));
    const std::vector<int> beside = this->neighbours(a);
    if (a == d || std::binary_search(beside.begin(), beside.end(), d))
    {
      return;
    }
    const int qa = s.twin[nextHalfedge(h)];
    const int ap = s.twin[previousHalfedge(h)];
    const int pd = s.twin[nextHalfedge(g)];
    const int dq = s.twin[previousHalfedge(g)];
    const int f = h / 3;
    const int e = g / 3;
    s.triangles[f] = { a, p, d };
    s.triangles[e] = { d, q, a };
    this->link(3 * f, ap);
    this->link(3 * f + 1, pd);
    this->link(3 * f + 2, 3 * e + 2);
    this->link(3 * e, dq);
    this->link(3 * e + 1, qa);
    this->refreshFirst({ f, e });
    this->Queue.push_back(f);
    this->Queue.push_back(e);
  }

  /// Drops a triangle whose longest edge is on the boundary.
  void dropAtBoundary(int h)
  {
    TriangleSurface& s = this->Surface;
    const int next = s.twin[nextHalfedge(h)];
    const int previous = s.twin[previousHalfedge(h)];
    if (next >= 0 && previous >= 0 && this->onBoundary(s.tail(previousHalfedge(h))))
    {
      return; // what is left would hang together in a point
    }
    this->Dropped[h / 3] = 1;
    std::vector<int> faces;
    for (int rest : { next, previous })
    {
      if (rest >= 0)
      {
        s.twin[rest] = -1;
        faces.push_back(rest / 3);
      }
    }
    this->refreshFirst(faces);
  }

  TriangleSurface& Surface;
  double Rounding;
  std::vector<char> Dropped;
  ElementArray<Vertex, Halfedge> First; // a halfedge that leaves each point, as vertexHalfedges()
                                        // has it
  std::deque<int> Queue;
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
  for (int f = 0; f < surface.numberOfFaces(); ++f)
  {
    if (!thin.isDropped(f))
    {
      surface.triangles[n] = surface.triangles[f];
      sourceCell[n++] = int(sourceCell[f]);
    }
  }
  surface.triangles.resize(n);
  sourceCell.resize(n);
  surface.connect();
  return found;
}
}
