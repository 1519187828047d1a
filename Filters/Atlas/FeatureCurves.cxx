// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureCurves.h"

#include "AtlasConstants.h"
#include "CellLocator.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <limits>
#include <unordered_map>

namespace stipple
{
using Constants = AtlasConstants;

namespace
{
class CurveInserter
{
public:
  explicit CurveInserter(CutSurface& surface)
    : Surface(surface)
    , Whole(surface.points, surface.triangles)
    , Outgoing(surface.vertexHalfedges())
    , InputTriangle(surface.triangles.size())
  {
    for (const Face f : surface.faces())
    {
      this->InputTriangle[f] = f;
    }
  }

  /// The vertex at the place of the surface nearest to a position; inserted if there is none.
  int insertPoint(const Vec3& x)
  {
    const CellLocator::Place found = this->Whole.nearest(x);
    const Vec3& place = found.position;
    // The piece of that triangle, which splits may have cut up, that has the place most inside.
    Face face(static_cast<int>(found.cell));
    Vec3 bary = this->barycentricIn(face, place);
    const auto pieces = this->Pieces.find(face);
    if (pieces != this->Pieces.end())
    {
      for (const Face piece : pieces->second)
      {
        const Vec3 inPiece = this->barycentricIn(piece, place);
        if (inPiece.minCoeff() > bary.minCoeff())
        {
          face = piece;
          bary = inPiece;
        }
      }
    }
    bary = clampedBarycentric(bary);
    int top = 0;
    const double largest = bary.maxCoeff(&top);
    if (largest > 1 - Constants::NearestToCurve)
    {
      return this->Surface.vertex(face, top).index();
    }
    // Split the edge across from the corner that counts most, then the edge from there to it.
    const Halfedge across = halfedgeOf(face, nextCorner(top));
    const double rest = 1 - largest;
    const double t = std::clamp(bary[previousCorner(top)] / rest, 0., 1.);
    int low = 0;
    const double least = bary.minCoeff(&low);
    if (least < Constants::NearestToCurve && low != top)
    {
      // On an edge of the triangle, next to the top corner.
      const int tail = low == nextCorner(top) ? previousCorner(top) : top;
      const int head = nextCorner(tail);
      return this->split(halfedgeOf(face, tail), bary[head] / (bary[tail] + bary[head]));
    }
    this->split(across, t);
    // The face now has the corners tail of across, new point, top.
    return this->split(nextHalfedge(across), largest);
  }

  /// Marks a curve from one vertex to another. False if it can't be followed.
  bool connect(int from, int to)
  {
    const Vec3 normal = (this->vertexNormal(from) + this->vertexNormal(to)).normalized();
    const Vec3 side = (this->Surface.points[to] - this->Surface.points[from]).cross(normal);
    int at = from;
    // The plane crosses each triangle once; more steps would go in a circle of vertices that the
    // curve snaps to.
    for (int stepsLeft = this->Surface.numberOfFaces(); at != to; --stepsLeft)
    {
      if (stepsLeft == 0)
      {
        return false;
      }
      const double left = (this->Surface.points[to] - this->Surface.points[at]).norm();
      Halfedge best; // an edge that the plane crosses, or one that ends on the plane
      double bestLeft = left;
      double bestT = 0;
      for (const Halfedge h : this->outgoing(at))
      {
        if (this->Surface.head(h).index() == to)
        {
          this->mark(h);
          return true;
        }
        const Halfedge e = nextHalfedge(h);
        const Vec3& a = this->Surface.point(this->Surface.tail(e));
        const Vec3& b = this->Surface.point(this->Surface.head(e));
        const double da = side.dot(a - this->Surface.points[from]);
        const double db = side.dot(b - this->Surface.points[from]);
        if (da * db > 0 || da == db)
        {
          continue;
        }
        const double t = da / (da - db);
        const Vec3 x = (1 - t) * a + t * b;
        const double there = (this->Surface.points[to] - x).norm();
        if (there < bestLeft)
        {
          best = e;
          bestLeft = there;
          bestT = t;
        }
      }
      if (!best.valid())
      {
        // The target may be reached by the last boundary edge, which no outgoing halfedge has.
        const Halfedge against = this->incomingFrom(at, to);
        if (against.valid())
        {
          this->mark(against);
        }
        return against.valid();
      }
      if (bestT < Constants::NearestToCurve || bestT > 1 - Constants::NearestToCurve)
      {
        const Halfedge along =
          bestT < Constants::NearestToCurve ? previousHalfedge(best) : nextHalfedge(best);
        this->mark(along);
        at =
          (bestT < Constants::NearestToCurve ? this->Surface.tail(best) : this->Surface.head(best))
            .index();
        continue;
      }
      at = this->split(best, bestT);
      this->mark(nextHalfedge(best));
    }
    return true;
  }

private:
  void mark(Halfedge h)
  {
    this->Surface.setSharp(h, true);
    this->Surface.setKeep(h, Keep::Line);
  }

  Vec3 barycentricIn(Face face, const Vec3& x) const
  {
    return barycentricInSpace(
      x, this->Surface.point(face, 0), this->Surface.point(face, 1), this->Surface.point(face, 2));
  }

  /// Halfedges that leave a vertex.
  std::vector<Halfedge> outgoing(int vertex) const
  {
    const Halfedge first = this->Outgoing[Vertex(vertex)];
    std::vector<Halfedge> around;
    Halfedge h = first;
    do // clockwise, as far as the boundary
    {
      around.push_back(h);
      h = this->Surface.isBoundary(h) ? Halfedge() : nextHalfedge(this->Surface.twin[h]);
    } while (h.valid() && h != first);
    if (!h.valid())
    {
      h = this->Surface.twin[previousHalfedge(first)];
      while (h.valid())
      {
        around.push_back(h);
        h = this->Surface.twin[previousHalfedge(h)];
      }
    }
    return around;
  }

  /// The halfedge from one vertex that arrives at another, none if there is none.
  Halfedge incomingFrom(int vertex, int from) const
  {
    for (const Halfedge h : this->outgoing(vertex))
    {
      if (this->Surface.tail(previousHalfedge(h)).index() == from)
      {
        return previousHalfedge(h);
      }
    }
    return {};
  }

  Vec3 vertexNormal(int vertex) const
  {
    Vec3 sum = Vec3::Zero();
    for (const Halfedge h : this->outgoing(vertex))
    {
      sum += this->Surface.faceNormal(faceOf(h));
    }
    return sum.normalized();
  }

  int split(Halfedge h, double t)
  {
    const Halfedge g = this->Surface.twin[h];
    const Face added(this->Surface.numberOfFaces());
    const Vertex tail = this->Surface.tail(h);
    const Vertex head = this->Surface.head(h);
    const int point = this->Surface.splitEdge(h, t);
    this->Outgoing.push_back(halfedgeOf(added, 0)); // to the head
    this->Outgoing[tail] = h;
    this->Outgoing[head] = halfedgeOf(added, 1);
    const auto adopt = [&](Face parent) {
      const Face input = this->InputTriangle[parent];
      this->Pieces[input].emplace_back(static_cast<int>(this->InputTriangle.size()));
      this->InputTriangle.push_back(input);
    };
    adopt(faceOf(h));
    if (g.valid())
    {
      adopt(faceOf(g));
    }
    return point;
  }

  CutSurface& Surface;
  CellLocator Whole;
  ElementArray<Vertex, Halfedge> Outgoing;            // a halfedge that leaves each vertex
  ElementArray<Face, Face> InputTriangle;             // of each face, the face before any split
  std::unordered_map<Face, std::vector<Face>> Pieces; // faces that splits made of an input triangle
};
}

Status insertFeatureCurves(CutSurface& surface, vtkPolyData* curves, const Progress& progress)
{
  CurveInserter inserter(surface);
  const vtkIdType numberOfPoints = curves->GetNumberOfPoints();
  const vtkIdType numberOfCurves = curves->GetNumberOfLines();
  auto lines = vtk::TakeSmartPointer(curves->GetLines()->NewIterator());
  for (lines->GoToFirstCell(); !lines->IsDoneWithTraversal(); lines->GoToNextCell())
  {
    const vtkIdType curve = lines->GetCurrentCellId();
    if (!report(progress, static_cast<double>(curve) / static_cast<double>(numberOfCurves)))
    {
      return Status::aborted();
    }
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    lines->GetCurrentCell(size, ids);
    int last = -1;
    for (vtkIdType i = 0; i < size; ++i)
    {
      if (ids[i] < 0 || ids[i] >= numberOfPoints)
      {
        return Status::error("Feature curve " + std::to_string(curve) + " has a point " +
          std::to_string(ids[i]) + ", but there are " + std::to_string(numberOfPoints) +
          " points.");
      }
      Vec3 x;
      curves->GetPoint(ids[i], x.data());
      if (!x.allFinite())
      {
        return Status::error("Point " + std::to_string(ids[i]) +
          " of the feature curves has a coordinate that is not a finite number.");
      }
      const int vertex = inserter.insertPoint(x);
      if (last >= 0 && vertex != last && !inserter.connect(last, vertex))
      {
        return Status::error("Feature curve " + std::to_string(curve) +
          " can't be followed on the surface from its point " + std::to_string(i - 1) +
          " to the next: place points closer to each other.");
      }
      last = vertex;
    }
  }
  return Status::success();
}
}
