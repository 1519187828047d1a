// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Triangles whose height is rounding: without area for all purposes, and with a meaningless normal.
#ifndef stipple_ThinTriangles_h
#define stipple_ThinTriangles_h

#include "TriangleSurface.h"

namespace stipple
{
/// Removes the triangles of a manifold surface whose height is at most a millionth of their longest
/// edge, or what rounding to single precision may leave of none (1e-7 of the bounding box's
/// diagonal, if that is at most a thousandth of the longest edge). Short edges are collapsed, long
/// ones swapped; at the boundary triangles are dropped. No point moves farther than that height
/// allows, and topology stays, but for parts that are all thin and vanish.
///
/// sourceCell, one a triangle, is kept in step; points may be left that no triangle uses. Returns
/// how many triangles were thin.
int removeThinTriangles(TriangleSurface& surface, std::vector<int>& sourceCell);
}

#endif
