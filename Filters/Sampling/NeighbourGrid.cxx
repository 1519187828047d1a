// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "NeighbourGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stipple
{
NeighbourGrid::NeighbourGrid(const Vec2& extent, std::size_t expectedPoints)
{
  const double n = std::clamp<double>(static_cast<double>(expectedPoints), 1., 4e6);
  const double size = std::sqrt(extent.x() * extent.y() / n);
  this->Columns = std::clamp(static_cast<int>(std::ceil(extent.x() / size)), 1, 4096);
  this->Lines = std::clamp(static_cast<int>(std::ceil(extent.y() / size)), 1, 4096);
  this->CellSize = { extent.x() / this->Columns, extent.y() / this->Lines };
  this->First.assign(static_cast<std::size_t>(this->Columns) * this->Lines, -1);
}

int NeighbourGrid::column(double x) const
{
  return std::clamp(static_cast<int>(x / this->CellSize.x()), 0, this->Columns - 1);
}

int NeighbourGrid::line(double y) const
{
  return std::clamp(static_cast<int>(y / this->CellSize.y()), 0, this->Lines - 1);
}

int NeighbourGrid::insert(const Vec2& p)
{
  const int id = static_cast<int>(this->Points.size());
  int& first = this->First[this->line(p.y()) * this->Columns + this->column(p.x())];
  this->Points.push_back(p);
  this->Next.push_back(first);
  first = id;
  return id;
}

void NeighbourGrid::remove(int id)
{
  const Vec2& p = this->Points[id];
  int* link = &this->First[this->line(p.y()) * this->Columns + this->column(p.x())];
  while (*link >= 0 && *link != id)
  {
    link = &this->Next[*link];
  }
  if (*link == id)
  {
    *link = this->Next[id];
  }
}

double NeighbourGrid::nearest(const Vec2& p, int except) const
{
  double best = std::numeric_limits<double>::max();
  const int cx = this->column(p.x());
  const int cy = this->line(p.y());
  const double side = this->CellSize.minCoeff();
  const int last = std::max(this->Columns, this->Lines);
  for (int ring = 0; ring <= last; ++ring)
  {
    // Every cell of this ring is at least (ring - 1) cells away.
    const double away = std::max(0, ring - 1) * side;
    if (away * away > best)
    {
      break;
    }
    for (int y = std::max(cy - ring, 0); y <= std::min(cy + ring, this->Lines - 1); ++y)
    {
      const bool whole = y == cy - ring || y == cy + ring;
      for (int x = cx - ring; x <= cx + ring; x += whole || ring == 0 ? 1 : 2 * ring)
      {
        if (x < 0 || x >= this->Columns)
        {
          continue;
        }
        for (int i = this->First[y * this->Columns + x]; i >= 0; i = this->Next[i])
        {
          if (i != except)
          {
            best = std::min(best, (this->Points[i] - p).squaredNorm());
          }
        }
      }
    }
  }
  return best;
}
}
