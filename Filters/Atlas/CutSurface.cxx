// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CutSurface.h"

#include <algorithm>

namespace stipple
{
CutSurface::CutSurface(TriangleSurface surface, std::vector<int> sourceCells)
  : TriangleSurface(std::move(surface))
  , sourceCell(std::move(sourceCells))
{
  this->numberOfOriginalPoints = static_cast<int>(this->points.size());
  this->cut.assign(this->twin.size(), 0);
  this->sharp.assign(this->twin.size(), 0);
  this->keep.assign(this->twin.size(), Keep::Nothing);
  for (const Halfedge h : this->halfedges())
  {
    this->cut[h] = this->isBoundary(h);
  }
}

void CutSurface::setCut(Halfedge h, bool isCut)
{
  this->cut[h] = isCut || this->isBoundary(h);
  if (!this->isBoundary(h))
  {
    this->cut[this->twin[h]] = isCut;
  }
}

void CutSurface::setSharp(Halfedge h, bool isSharp)
{
  this->sharp[h] = isSharp;
  if (!this->isBoundary(h))
  {
    this->sharp[this->twin[h]] = isSharp;
  }
}

void CutSurface::setRounded(Halfedge h)
{
  this->setSharp(h, true);
  for (const Halfedge side : { h, this->twin[h] })
  {
    if (side.valid())
    {
      this->sharp[side] = Rounded;
    }
  }
}

void CutSurface::setKeep(Halfedge h, Keep least)
{
  this->keep[h] = std::max(this->keep[h], least);
  if (this->twin[h].valid())
  {
    this->keep[this->twin[h]] = this->keep[h];
  }
}

void CutSurface::link(Halfedge h, Halfedge t)
{
  this->twin[h] = t;
  if (t.valid())
  {
    this->twin[t] = h;
  }
}

Halfedge CutSurface::nextOnBoundary(Halfedge h) const
{
  Halfedge g = nextHalfedge(h);
  while (!this->cut[g])
  {
    g = nextHalfedge(this->twin[g]);
  }
  return g;
}

int CutSurface::numberOfCutsAround(Halfedge h) const
{
  int cuts = 0;
  Halfedge g = h;
  do
  {
    cuts += this->cut[g];
    if (this->isBoundary(g))
    {
      return cuts + 1;
    }
    g = nextHalfedge(this->twin[g]);
  } while (g != h);
  return cuts;
}

void CutSurface::flipEdge(Halfedge h)
{
  const Halfedge g = this->twin[h];
  struct Side
  {
    Halfedge twin;
    char cut;
    char sharp;
    Keep keep;
  };
  const auto take = [&](Halfedge e) {
    return Side{ this->twin[e], this->cut[e], this->sharp[e], this->keep[e] };
  };
  const auto put = [&](Halfedge e, const Side& side) {
    this->link(e, side.twin);
    this->cut[e] = side.cut;
    this->sharp[e] = side.sharp;
    this->keep[e] = side.keep;
  };
  // h from a to b under c, g back under d; then h from d to c beside a, g back beside b
  const int a = this->tail(h).index();
  const int b = this->head(h).index();
  const int c = this->tail(previousHalfedge(h)).index();
  const int d = this->tail(previousHalfedge(g)).index();
  const Side bc = take(nextHalfedge(h));
  const Side ca = take(previousHalfedge(h));
  const Side ad = take(nextHalfedge(g));
  const Side db = take(previousHalfedge(g));
  const auto setCorners = [&](Halfedge e, int p, int q, int r) {
    Triangle& t = this->triangles[faceOf(e).index()];
    t[cornerOf(e)] = p;
    t[cornerOf(nextHalfedge(e))] = q;
    t[cornerOf(previousHalfedge(e))] = r;
  };
  setCorners(h, d, c, a);
  setCorners(g, c, d, b);
  put(nextHalfedge(h), ca);
  put(previousHalfedge(h), ad);
  put(nextHalfedge(g), db);
  put(previousHalfedge(g), bc);
}

int CutSurface::splitEdge(Halfedge h, double t)
{
  const int a = this->tail(h).index();
  const int b = this->head(h).index();
  const int m = static_cast<int>(this->points.size());
  this->points.push_back(Vec3((1 - t) * this->points[a] + t * this->points[b]));
  this->inserted.push_back({ a, b, t });

  // On each side the triangle keeps the half that begins at its halfedge's tail; the other half is
  // new.
  const auto splitSide = [&](Halfedge g) {
    const Face f = faceOf(g);
    const Halfedge n = nextHalfedge(g);
    const Face added(this->numberOfFaces());
    this->triangles.push_back(
      { m, this->head(g).index(), this->tail(previousHalfedge(g)).index() });
    this->triangles[f.index()][cornerOf(n)] = m;
    this->sourceCell.push_back(int(this->sourceCell[f.index()]));
    this->twin.resize(this->numberOfHalfedges());
    this->cut.resize(this->numberOfHalfedges(), 0);
    this->sharp.resize(this->numberOfHalfedges(), 0);
    this->keep.resize(this->numberOfHalfedges(), Keep::Nothing);
    const Halfedge along = halfedgeOf(added, 0);
    const Halfedge outside = halfedgeOf(added, 1);
    this->cut[along] = this->cut[g];
    this->sharp[along] = this->sharp[g];
    this->keep[along] = this->keep[g];
    this->link(outside, this->twin[n]);
    this->cut[outside] = this->cut[n];
    this->sharp[outside] = this->sharp[n];
    this->keep[outside] = this->keep[n];
    this->link(halfedgeOf(added, 2), n);
    this->cut[n] = 0;
    this->sharp[n] = 0;
    this->keep[n] = Keep::Nothing;
    return along;
  };
  const Halfedge g = this->twin[h];
  const Halfedge h2 = splitSide(h); // m -> b
  if (g.valid())
  {
    const Halfedge g2 = splitSide(g); // m -> a
    this->link(h, g2);
    this->link(g, h2);
  }
  return m;
}
}
