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
  for (std::size_t h = 0; h < this->twin.size(); ++h)
  {
    this->cut[h] = this->twin[h] < 0;
  }
}

void CutSurface::setCut(int h, bool isCut)
{
  const int t = this->twin[h];
  this->cut[h] = isCut || t < 0;
  if (t >= 0)
  {
    this->cut[t] = isCut;
  }
}

void CutSurface::setSharp(int h, bool isSharp)
{
  this->sharp[h] = isSharp;
  if (this->twin[h] >= 0)
  {
    this->sharp[this->twin[h]] = isSharp;
  }
}

void CutSurface::setKeep(int h, Keep least)
{
  this->keep[h] = std::max(this->keep[h], least);
  if (this->twin[h] >= 0)
  {
    this->keep[this->twin[h]] = this->keep[h];
  }
}

void CutSurface::link(int h, int t)
{
  this->twin[h] = t;
  if (t >= 0)
  {
    this->twin[t] = h;
  }
}

int CutSurface::splitEdge(int h, double t)
{
  const int a = this->tail(h);
  const int b = this->head(h);
  const int m = static_cast<int>(this->points.size());
  this->points.push_back(Vec3((1 - t) * this->points[a] + t * this->points[b]));
  this->inserted.push_back({ a, b, t });

  // On each side the triangle keeps the half that begins at its halfedge's tail; the other half is
  // new.
  const auto splitSide = [&](int g) {
    const int f = g / 3;
    const int k = g % 3;
    const int n = nextHalfedge(g);
    const int apex = this->triangles[f][(k + 2) % 3];
    const int added = 3 * this->numberOfFaces();
    this->triangles.push_back({ m, this->triangles[f][(k + 1) % 3], apex });
    this->triangles[f][(k + 1) % 3] = m;
    this->sourceCell.push_back(int(this->sourceCell[f]));
    this->twin.resize(added + 3);
    this->cut.resize(added + 3, 0);
    this->sharp.resize(added + 3, 0);
    this->keep.resize(added + 3, Keep::Nothing);
    this->cut[added] = this->cut[g];
    this->sharp[added] = this->sharp[g];
    this->keep[added] = this->keep[g];
    this->link(added + 1, this->twin[n]);
    this->cut[added + 1] = this->cut[n];
    this->sharp[added + 1] = this->sharp[n];
    this->keep[added + 1] = this->keep[n];
    this->link(added + 2, n);
    this->cut[n] = 0;
    this->sharp[n] = 0;
    this->keep[n] = Keep::Nothing;
    return added;
  };
  const int g = this->twin[h];
  const int h2 = splitSide(h); // m -> b
  if (g >= 0)
  {
    const int g2 = splitSide(g); // m -> a
    this->link(h, g2);
    this->link(g, h2);
  }
  return m;
}
}
