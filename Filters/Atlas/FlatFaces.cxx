// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FlatFaces.h"

#include "AtlasConstants.h"

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <set>

namespace stipple
{
using Constants = AtlasConstants;

namespace
{
class FlatFaces
{
public:
  FlatFaces(CutSurface& surface, const MayFlip& mayFlip)
    : Surface(surface)
    , Agrees(mayFlip)
    , MostDistance(Constants::FlatFace * surface.boundingBoxDiagonal())
    , Moved(surface.numberOfFaces(), 0.)
  {
  }

  /// It ends: an edge that was flipped away never comes back, and there are only so many pairs of
  /// vertices. (In one plane it would not come back anyway.)
  std::vector<std::pair<int, int>> run()
  {
    std::vector<Halfedge> open;
    for (const Face f : this->Surface.faces())
    {
      if (isSliver(this->Surface.point(f, 0), this->Surface.point(f, 1), this->Surface.point(f, 2)))
      {
        for (const Halfedge h : halfedgesOf(f))
        {
          open.push_back(h);
        }
      }
    }
    std::vector<std::pair<int, int>> joined;
    while (!open.empty())
    {
      const Halfedge h = open.back();
      open.pop_back();
      if (const std::optional<Crossing> crossing = this->wantedFlip(h))
      {
        const Halfedge g = this->Surface.twin[h];
        this->Moved[faceOf(h)] = this->Moved[faceOf(g)] = crossing->moved;
        this->Gone.insert(ends(this->Surface.tail(h), this->Surface.head(h)));
        joined.emplace_back(
          this->Surface.sourceCell[faceOf(h).index()], this->Surface.sourceCell[faceOf(g).index()]);
        this->Surface.flipEdge(h);
        for (const Halfedge e :
          { nextHalfedge(h), previousHalfedge(h), nextHalfedge(g), previousHalfedge(g) })
        {
          open.push_back(e);
        }
      }
    }
    return joined;
  }

private:
  /// Where two diagonals cross, as shares of them, and how far the surface will have moved there.
  struct Crossing
  {
    double along;
    double across;
    double moved;
  };

  static std::pair<Vertex, Vertex> ends(Vertex a, Vertex b)
  {
    return { std::min(a, b), std::max(a, b) };
  }

  std::optional<Crossing> wantedFlip(Halfedge h) const
  {
    const CutSurface& s = this->Surface;
    const Halfedge g = s.twin[h];
    if (!g.valid() || s.cut[h] != 0 || s.isFeature(h))
    {
      return std::nullopt;
    }
    const Vertex c = s.tail(previousHalfedge(h));
    const Vertex d = s.tail(previousHalfedge(g));
    const Vec3& a = s.point(s.tail(h));
    const Vec3& b = s.point(s.head(h));
    if (isDelaunay(a, b, s.point(c), s.point(d)) || c == d || this->isJoined(d, h) ||
      this->Gone.count(ends(c, d)) > 0)
    {
      return std::nullopt;
    }
    const std::optional<Crossing> crossing = this->crossing(
      a, b, s.point(c), s.point(d), std::max(this->Moved[faceOf(h)], this->Moved[faceOf(g)]));
    return crossing && this->Agrees(h, crossing->along, crossing->across) ? crossing : std::nullopt;
  }

  static bool isSliver(const Vec3& a, const Vec3& b, const Vec3& c)
  {
    const double area = (b - a).cross(c - a).norm();
    const double least = std::min({ std::atan2(area, (b - a).dot(c - a)),
      std::atan2(area, (c - b).dot(a - b)), std::atan2(area, (a - c).dot(b - c)) });
    return least < Constants::SliverAngle;
  }

  /// Whether the angles over an edge sum to no more than pi.
  static bool isDelaunay(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
  {
    const auto angle = [&](const Vec3& apex) {
      const Vec3 u = a - apex;
      const Vec3 w = b - apex;
      return std::atan2(u.cross(w).norm(), u.dot(w));
    };
    return angle(c) + angle(d) <= Pi + Constants::LeastBeyondDelaunay;
  }

  /// Where two diagonals cross inside both, if the surface moves little when one takes the other's
  /// place. All of its way since it was the input's adds up.
  std::optional<Crossing> crossing(
    const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, double movedSoFar) const
  {
    const Vec3 u = b - a;
    const Vec3 w = d - c;
    const Vec3 n = u.cross(w);
    const double area = n.norm(); // twice the quadrilateral's
    const double longest = std::max(u.norm(), w.norm());
    const double most = std::min(this->MostDistance, Constants::FlatFaceOverEdge * longest);
    if (!(area > most * longest))
    {
      return std::nullopt;
    }
    const double distance = std::abs((c - a).dot(n)) / area;
    if (distance > std::min(most, this->MostDistance - movedSoFar))
    {
      return std::nullopt;
    }
    const double s = (c - a).cross(w).dot(n) / (area * area);
    const double t = (c - a).cross(u).dot(n) / (area * area);
    const auto isInside = [](double share) {
      return share > Constants::LeastCrossing && share < 1 - Constants::LeastCrossing;
    };
    if (!isInside(s) || !isInside(t))
    {
      return std::nullopt;
    }
    return Crossing{ s, t, movedSoFar + distance };
  }

  /// Whether there is an edge between the apex of h and d already.
  bool isJoined(Vertex d, Halfedge h) const
  {
    const CutSurface& s = this->Surface;
    // To one side, and if that ends at a boundary to the other.
    Halfedge e = previousHalfedge(h);
    const Halfedge first = e;
    do
    {
      if (s.head(e) == d || s.tail(previousHalfedge(e)) == d)
      {
        return true;
      }
      e = s.twin[previousHalfedge(e)];
    } while (e.valid() && e != first);
    for (e = first; e.valid() && s.twin[e].valid();)
    {
      e = nextHalfedge(s.twin[e]);
      if (e == first)
      {
        break;
      }
      if (s.head(e) == d)
      {
        return true;
      }
    }
    return false;
  }

  CutSurface& Surface;
  const MayFlip& Agrees;
  const double MostDistance;
  ElementArray<Face, double> Moved; ///< how far a triangle is from the input at most
  std::set<std::pair<Vertex, Vertex>> Gone;
};
}

std::vector<std::pair<int, int>> triangulateFlatFaces(CutSurface& surface, const MayFlip& mayFlip)
{
  return FlatFaces(surface, mayFlip).run();
}

FlatFaceCells flatFaceCells(
  const RepairedSurface& repaired, const std::vector<std::pair<int, int>>& joined)
{
  if (joined.empty())
  {
    return {};
  }
  const std::vector<int>& source = repaired.sourceCell;
  const int numberOfCells = 1 + *std::max_element(source.begin(), source.end());
  boost::disjoint_sets_with_storage<> sets(static_cast<std::size_t>(numberOfCells));
  for (const auto& [a, b] : joined)
  {
    sets.union_set(a, b);
  }
  std::vector<int> size(static_cast<std::size_t>(numberOfCells), 0);
  for (int cell = 0; cell < numberOfCells; ++cell)
  {
    ++size[sets.find_set(cell)];
  }
  std::map<std::size_t, std::vector<FlatFaceCells::Piece>> pieces; // by set
  for (const Face f : repaired.surface.faces())
  {
    const std::size_t set = sets.find_set(source[f.index()]);
    if (size[set] > 1)
    {
      pieces[set].push_back({ source[f.index()],
        { { repaired.surface.point(f, 0), repaired.surface.point(f, 1),
          repaired.surface.point(f, 2) } } });
    }
  }
  FlatFaceCells faces;
  for (auto& [set, face] : pieces)
  {
    faces.add(std::move(face));
  }
  return faces;
}
}
