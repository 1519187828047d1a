// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Nearest neighbours among points of a rectangle that come and go.
#ifndef stipple_NeighbourGrid_h
#define stipple_NeighbourGrid_h

#include "Geometry.h"
#include "StippleFiltersSamplingModule.h"

#include <vector>

namespace stipple
{
class STIPPLEFILTERSSAMPLING_EXPORT NeighbourGrid
{
public:
  /// Cells for about expectedPoints points in [0, extent].
  NeighbourGrid(const Vec2& extent, std::size_t expectedPoints);
  /// Adds a point; points are numbered in the order of insertion.
  int insert(const Vec2& p);
  void remove(int id);
  /// The squared distance from p to the nearest point other than `except`; huge if there is none.
  double nearest(const Vec2& p, int except = -1) const;

private:
  int column(double x) const;
  int line(double y) const;
  Vec2 CellSize;
  int Columns;
  int Lines;
  std::vector<int> First; ///< by cell
  std::vector<int> Next;  ///< by point
  std::vector<Vec2> Points;
};
}

#endif
