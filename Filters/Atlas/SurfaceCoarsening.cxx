// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceCoarsening.h"

#include "AtlasConstants.h"
#include "FaceSets.h"

#include <algorithm>
#include <map>

namespace stipple
{
using Constants = AtlasConstants;

/// Works on the surface's own halfedges: a triangle that is gone keeps its links, which say where
/// it was.
class SurfaceCoarsening::Builder
{
public:
  explicit Builder(SurfaceCoarsening& result)
    : Result(result)
    , Points(result.Fine.points)
    , Twin(result.Twin)
    , IsLine(result.IsLine)
    , Triangles(result.Fine.triangles)
    , Sharp(result.Fine.sharp)
    , Kept(result.Fine.keep)
    , First(result.Fine.vertexHalfedges())
    , IsGone(result.Fine.triangles.size(), 0)
    , IsFixed(result.Fine.points.size(), 0)
    , IsNeighbour(result.Fine.points.size(), 0)
    , Left(result.Fine.numberOfFaces())
  {
    const CutSurface& fine = result.Fine;
    this->Twin = fine.twin;
    this->IsLine.assign(fine.numberOfHalfedges(), 0);
    for (const Halfedge h : fine.halfedges())
    {
      this->IsLine[h] = fine.isBoundary(h) || fine.isCrease(h) || fine.keep[h] != Keep::Nothing;
      if (fine.isRounded(h))
      {
        this->Sharp[h] = 0; // no chart ends there for its sake
      }
      if (fine.keep[h] == Keep::Edges)
      {
        this->IsFixed[fine.tail(h)] = this->IsFixed[fine.head(h)] = 1;
      }
    }
    for (const Vertex v : fine.vertices())
    {
      if (this->First[v].valid())
      {
        this->Vertices.push_back(v);
      }
    }
  }

  void collapseTo(int numberOfTriangles, const Stop& stop)
  {
    // Every sweep takes a share of the vertices away, or is the last.
    for (bool goesOn = true; goesOn && this->Left > numberOfTriangles && !isAsked(stop);)
    {
      const std::size_t before = this->Vertices.size();
      this->sweep(numberOfTriangles, stop);
      goesOn = static_cast<double>(before - this->Vertices.size()) >
        Constants::LeastCoarsening * static_cast<double>(before);
    }
  }

  void finish()
  {
    const CutSurface& fine = this->Result.Fine;
    std::vector<int> coarseVertex(this->Points.size(), -1);
    ElementArray<Face, int> coarseFace(this->IsGone.size(), -1);
    TriangleSurface coarse;
    for (const Vertex v : this->Vertices)
    {
      coarseVertex[v.index()] = coarse.numberOfVertices();
      coarse.points.push_back(fine.point(v));
    }
    std::vector<int> sourceCell;
    for (const Face f : fine.faces())
    {
      if (!this->IsGone[f])
      {
        coarseFace[f] = coarse.numberOfFaces();
        sourceCell.push_back(coarse.numberOfFaces());
        this->Result.FineFaces.push_back(f);
        const Triangle& t = this->Triangles[f.index()];
        coarse.triangles.push_back({ coarseVertex[t[0]], coarseVertex[t[1]], coarseVertex[t[2]] });
      }
    }
    const auto coarseHalfedge = [&](Halfedge h) {
      return h.valid() ? halfedgeOf(Face(coarseFace[faceOf(h)]), cornerOf(h)) : Halfedge();
    };
    for (const Face f : this->Result.FineFaces)
    {
      for (const Halfedge h : halfedgesOf(f))
      {
        coarse.twin.push_back(coarseHalfedge(this->Twin[h]));
      }
    }
    this->Result.Coarse = CutSurface(std::move(coarse), std::move(sourceCell));
    for (const Face f : this->Result.FineFaces)
    {
      for (const Halfedge h : halfedgesOf(f))
      {
        this->Result.Coarse.sharp[coarseHalfedge(h)] = this->Sharp[h];
        this->Result.Coarse.keep[coarseHalfedge(h)] = this->Kept[h];
      }
    }
  }

private:
  Vertex tail(Halfedge h) const { return Vertex(this->Triangles[faceOf(h).index()][cornerOf(h)]); }
  Vertex head(Halfedge h) const { return this->tail(nextHalfedge(h)); }
  double length(Halfedge h) const
  {
    return (this->point(this->head(h)) - this->point(this->tail(h))).norm();
  }
  const Vec3& point(Vertex v) const { return this->Points[v.index()]; }
  /// Whether s is of one of the two triangles beside an edge.
  static bool isBeside(Halfedge s, Halfedge h, Halfedge twin)
  {
    return faceOf(s) == faceOf(h) || (twin.valid() && faceOf(s) == faceOf(twin));
  }

  /// The halfedges out of v, counterclockwise.
  const std::vector<Halfedge>& star(Vertex v)
  {
    this->Star.clear();
    Halfedge h = this->First[v];
    do
    {
      this->Star.push_back(h);
      h = this->Twin[previousHalfedge(h)];
    } while (h.valid() && h != this->First[v]);
    return this->Star;
  }

  /// Collapses edges that are not longer than the mean, no two of them beside one another, so that
  /// all of the surface gets coarser alike.
  void sweep(int numberOfTriangles, const Stop& stop)
  {
    const double longest = this->meanLength();
    std::vector<char> isTouched(this->Points.size(), 0);
    std::vector<Vertex> left;
    left.reserve(this->Vertices.size());
    bool isLast = false;
    for (std::size_t i = 0; i < this->Vertices.size(); ++i)
    {
      const Vertex v = this->Vertices[i];
      isLast = isLast || this->Left <= numberOfTriangles || (isTimeToAsk(i) && isAsked(stop));
      const Halfedge h =
        isLast || isTouched[v.index()] ? Halfedge() : this->bestCollapse(v, longest);
      if (!h.valid())
      {
        left.push_back(v);
        continue;
      }
      for (const Halfedge s : this->star(v))
      {
        isTouched[this->head(s).index()] = 1;
        isTouched[this->tail(previousHalfedge(s)).index()] = 1;
      }
      this->collapse(h);
    }
    this->Vertices = std::move(left);
  }

  double meanLength() const
  {
    double sum = 0;
    for (const Face f : this->IsGone.ids())
    {
      if (!this->IsGone[f])
      {
        for (const Halfedge h : halfedgesOf(f))
        {
          sum += this->length(h);
        }
      }
    }
    return sum / (3. * this->Left);
  }

  /// The shortest edge out of v that may collapse, if any. A vertex on a line stays on it; where
  /// lines end, branch or turn, it stays.
  Halfedge bestCollapse(Vertex v, double longest)
  {
    if (this->IsFixed[v])
    {
      return {};
    }
    const std::vector<Halfedge>& out = this->star(v);
    const bool isOnBoundary = !this->Twin[out.front()].valid();
    std::vector<Halfedge>& candidates = this->Candidates;
    candidates.clear();
    for (const Halfedge h : out)
    {
      if (this->IsLine[h])
      {
        candidates.push_back(h);
      }
    }
    if (isOnBoundary ? candidates.size() != 1 || out.size() < 2
                     : !candidates.empty() && candidates.size() != 2)
    {
      return {};
    }
    if (candidates.empty())
    {
      candidates = out;
    }
    else
    {
      const Vec3 one = this->point(this->head(candidates[0])) - this->point(v);
      const Vertex other =
        isOnBoundary ? this->tail(previousHalfedge(out.back())) : this->head(candidates[1]);
      const Vec3 two = this->point(other) - this->point(v);
      if (one.dot(two) > -Constants::StraightLine * one.norm() * two.norm())
      {
        return {};
      }
    }
    Halfedge best;
    double bestLength = longest;
    for (const Halfedge h : candidates)
    {
      const double length = this->length(h);
      if (length <= bestLength && this->keepsTopology(h, out) && this->keepsShape(h, out))
      {
        best = h;
        bestLength = length;
      }
    }
    return best;
  }

  /// The link condition: the ends have no neighbours in common but the corners across the edge, and
  /// no edge across (Dey et al. 1999), as those of a tetrahedron; and a line does not collapse into
  /// another.
  bool keepsTopology(Halfedge h, const std::vector<Halfedge>& out)
  {
    const Halfedge g = this->Twin[h];
    const auto joinsLines = [this](Halfedge a, Halfedge b) {
      return this->IsLine[a] && this->IsLine[b];
    };
    if (joinsLines(nextHalfedge(h), previousHalfedge(h)) ||
      (g.valid() && joinsLines(nextHalfedge(g), previousHalfedge(g))))
    {
      return false;
    }
    const auto mark = [&](char value) {
      Halfedge last;
      const Vertex w = this->head(h);
      Halfedge e = this->First[w];
      int valence = 0;
      do
      {
        this->IsNeighbour[this->head(e)] = value;
        last = previousHalfedge(e);
        e = this->Twin[last];
        ++valence;
      } while (e.valid() && e != this->First[w]);
      this->IsNeighbour[this->tail(last)] = value;
      return valence;
    };
    const int valence = mark(1);
    int common = 0;
    for (const Halfedge s : out)
    {
      common += this->IsNeighbour[this->head(s)];
    }
    if (!g.valid())
    {
      common += this->IsNeighbour[this->tail(previousHalfedge(out.back()))];
    }
    mark(0);
    const auto isInside = [this](Vertex u) { return this->Twin[this->First[u]].valid(); };
    const bool hasEdgeAcross =
      valence == 3 && out.size() == 3 && isInside(this->tail(h)) && isInside(this->head(h));
    return common == (g.valid() ? 2 : 1) && !hasEdgeAcross &&
      valence + static_cast<int>(out.size()) - 4 <= Constants::MostAboutCoarseVertex;
  }

  /// No triangle turns over, and none becomes a sliver that was none.
  bool keepsShape(Halfedge h, const std::vector<Halfedge>& out) const
  {
    const Vec3& w = this->point(this->head(h));
    const auto height = [](const Vec3& cross, const Vec3& a, const Vec3& b, const Vec3& c) {
      return cross.norm() /
        std::max({ (b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm(), 1e-300 });
    };
    for (const Halfedge s : out)
    {
      if (isBeside(s, h, this->Twin[h]))
      {
        continue; // its triangle goes
      }
      const Vec3& v = this->point(this->tail(s));
      const Vec3& a = this->point(this->head(s));
      const Vec3& b = this->point(this->tail(previousHalfedge(s)));
      const Vec3 before = (a - v).cross(b - v);
      const Vec3 after = (a - w).cross(b - w);
      if (after.dot(before) < Constants::LeastCosineOfCoarsening * after.norm() * before.norm() ||
        height(after, w, a, b) < std::min(Constants::LeastCoarseHeight, height(before, v, a, b)))
      {
        return false;
      }
    }
    return true;
  }

  void collapse(Halfedge h)
  {
    const Vertex v = this->tail(h);
    const Vertex w = this->head(h);
    const Halfedge g = this->Twin[h];
    this->Result.Collapsed.push_back(h);
    for (const Halfedge s : this->star(v))
    {
      if (!isBeside(s, h, g))
      {
        this->Triangles[faceOf(s).index()][cornerOf(s)] = w.index();
      }
    }
    const Halfedge beyond = this->Twin[nextHalfedge(h)];
    this->close(h);
    if (g.valid())
    {
      this->close(g);
    }
    if (this->IsGone[faceOf(this->First[w])])
    {
      // If w was on the boundary there, its edge on it is the one that v brought.
      this->First[w] = beyond.valid() ? nextHalfedge(beyond) : this->Twin[previousHalfedge(h)];
    }
    this->First[v] = {};
  }

  /// Takes the triangle left of h away: what is beyond its two other edges meets.
  void close(Halfedge h)
  {
    const Halfedge next = nextHalfedge(h);
    const Halfedge previous = previousHalfedge(h);
    const Halfedge one = this->Twin[next];
    const Halfedge other = this->Twin[previous];
    const Vertex across = this->tail(previous);
    this->IsGone[faceOf(h)] = 1;
    --this->Left;
    const Halfedge line = this->IsLine[next] ? next : previous;
    for (const auto& [to, from] : { std::make_pair(one, other), std::make_pair(other, one) })
    {
      if (to.valid())
      {
        this->Twin[to] = from;
        this->IsLine[to] = this->IsLine[line];
        this->Sharp[to] = this->Sharp[line];
        this->Kept[to] = this->Kept[line];
      }
    }
    if (faceOf(this->First[across]) == faceOf(h))
    {
      this->First[across] = one; // there is one: else its first halfedge was on the boundary
    }
  }

  SurfaceCoarsening& Result;
  const std::vector<Vec3>& Points;
  HalfedgeTwins& Twin;
  ElementArray<Halfedge, char>& IsLine;
  std::vector<Triangle> Triangles;
  ElementArray<Halfedge, char> Sharp;
  ElementArray<Halfedge, Keep> Kept;
  ElementArray<Vertex, Halfedge> First;
  ElementArray<Face, char> IsGone;
  ElementArray<Vertex, char> IsFixed;
  ElementArray<Vertex, char> IsNeighbour; // scratch
  std::vector<Halfedge> Star;             // scratch
  std::vector<Halfedge> Candidates;       // scratch
  std::vector<Vertex> Vertices;           // that are left
  int Left;
};

SurfaceCoarsening::SurfaceCoarsening(
  const CutSurface& surface, int numberOfTriangles, const Stop& stop)
  : Fine(surface)
{
  Builder builder(*this);
  builder.collapseTo(numberOfTriangles, stop);
  builder.finish();
}

namespace
{
/// Takes collapses back, the last one first, and carries cuts along.
class VertexSplits
{
public:
  VertexSplits(HalfedgeTwins twin, const ElementArray<Halfedge, char>& isLine)
    : Twin(std::move(twin))
    , IsLine(isLine)
    , Cut(this->Twin.size(), 0)
  {
  }

  void setCut(Halfedge h, bool isCut)
  {
    this->Cut[h] = isCut;
    if (this->Twin[h].valid())
    {
      this->Cut[this->Twin[h]] = isCut;
    }
  }
  ElementArray<Halfedge, char> takeCuts() { return std::move(this->Cut); }

  /// Splits the vertex that the tail of h went into. An edge on either side of h comes apart into
  /// one that is the tail's and one that is the head's. If it was cut, one of these is: the one on
  /// a line, or that of the end about which there are other cuts.
  void split(Halfedge h)
  {
    struct Side
    {
      Halfedge ofTail; // of the triangle beside h
      Halfedge ofHead;
      bool isCut;
    };
    const Halfedge g = this->Twin[h];
    std::vector<Side> sides = { { previousHalfedge(h), nextHalfedge(h), false } };
    if (g.valid())
    {
      sides.push_back({ nextHalfedge(g), previousHalfedge(g), false });
    }
    for (Side& side : sides)
    {
      side.isCut = this->Cut[this->Twin[side.ofTail]];
      for (const Halfedge e : { side.ofTail, side.ofHead })
      {
        if (this->Twin[e].valid())
        {
          this->Twin[this->Twin[e]] = e;
        }
      }
    }
    bool aboutTail = !g.valid() || this->isCutBetween(this->Twin[sides[0].ofTail], sides[1].ofTail);
    bool aboutHead = !g.valid() || this->isCutBetween(this->Twin[sides[1].ofHead], sides[0].ofHead);
    const auto isDrawnTo = [&](Halfedge Side::*end) {
      return std::any_of(sides.begin(), sides.end(),
        [&](const Side& side) { return side.isCut && this->IsLine[side.*end]; });
    };
    const bool toTail =
      (aboutTail || isDrawnTo(&Side::ofTail)) && !(aboutHead || isDrawnTo(&Side::ofHead));
    for (const Side& side : sides)
    {
      const bool isAtTail =
        side.isCut && (this->IsLine[side.ofTail] || (toTail && !this->IsLine[side.ofHead]));
      const bool isAtHead = side.isCut && !isAtTail;
      this->setCut(side.ofTail, isAtTail);
      this->setCut(side.ofHead, isAtHead);
      aboutTail = aboutTail || isAtTail;
      aboutHead = aboutHead || isAtHead;
    }
    this->setCut(h, aboutTail && aboutHead);
  }

private:
  /// Whether one of the edges about a vertex is cut that come, counterclockwise, after `from` and
  /// before `to`, both out of it; a boundary counts.
  bool isCutBetween(Halfedge from, Halfedge to) const
  {
    for (Halfedge h = from; h.valid();)
    {
      h = this->Twin[previousHalfedge(h)];
      if (h == to)
      {
        return false;
      }
      if (h.valid() && this->Cut[h])
      {
        return true;
      }
    }
    return true;
  }

  HalfedgeTwins Twin;
  const ElementArray<Halfedge, char>& IsLine;
  ElementArray<Halfedge, char> Cut;
};
}

/// Cuts moved to the coarse surface's own edges, by its halfedges.
ElementArray<Halfedge, char> SurfaceCoarsening::alongEdges(const CutSurface& cutCoarse) const
{
  const FaceSets charts(cutCoarse, [&](Halfedge h) { return cutCoarse.cut[h] == 0; });
  const auto source = [&](Face f) {
    return Face(cutCoarse.sourceCell[static_cast<std::size_t>(f.index())]);
  };
  std::map<std::pair<Face, int>, double> areas;
  for (const Face f : cutCoarse.faces())
  {
    areas[{ source(f), charts.of[f] }] += cutCoarse.faceArea(f);
  }
  ElementArray<Face, int> chart(this->FineFaces.size(), -1);
  ElementArray<Face, double> most(this->FineFaces.size(), -1.);
  for (const auto& [piece, area] : areas)
  {
    if (area > most[piece.first])
    {
      most[piece.first] = area;
      chart[piece.first] = piece.second;
    }
  }
  ElementArray<Halfedge, char> cuts(this->Coarse.twin.size(), 0);
  for (const Halfedge h : this->Coarse.halfedges())
  {
    const Halfedge twin = this->Coarse.twin[h];
    cuts[h] = !twin.valid() || chart[faceOf(h)] != chart[faceOf(twin)];
  }
  for (const Halfedge h : cutCoarse.halfedges())
  {
    const Halfedge twin = cutCoarse.twin[h];
    if (!cutCoarse.cut[h] || !twin.valid() || charts.of[faceOf(h)] != charts.of[faceOf(twin)])
    {
      continue;
    }
    for (const Halfedge e : halfedgesOf(source(faceOf(h))))
    {
      // Pieces of two triangles meet along what was the edge between these.
      const Halfedge across = this->Coarse.twin[e];
      if (across.valid() && faceOf(across) == source(faceOf(twin)))
      {
        cuts[e] = cuts[across] = 1;
      }
    }
  }
  return cuts;
}

ElementArray<Halfedge, char> SurfaceCoarsening::prolong(
  const CutSurface& cutCoarse, const Stop& stop) const
{
  const ElementArray<Halfedge, char> coarseCuts = this->alongEdges(cutCoarse);
  VertexSplits splits(this->Twin, this->IsLine);
  for (const Halfedge h : this->Coarse.halfedges())
  {
    const Face fine = this->FineFaces[static_cast<std::size_t>(faceOf(h).index())];
    splits.setCut(halfedgeOf(fine, cornerOf(h)), coarseCuts[h] != 0);
  }
  for (std::size_t i = this->Collapsed.size(); i > 0 && !(isTimeToAsk(i) && isAsked(stop)); --i)
  {
    splits.split(this->Collapsed[i - 1]);
  }
  return splits.takeCuts();
}
}
