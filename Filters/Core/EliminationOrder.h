// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// In which order the unknowns of a sparse matrix are eliminated, so that little is filled in.
#ifndef stipple_EliminationOrder_h
#define stipple_EliminationOrder_h

#include "Progress.h"
#include "StippleFiltersCoreModule.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>

namespace stipple
{
/// From an unknown's number to its place in the order; empty if it is stopped. Takes the lower
/// triangle of a symmetric matrix. Nested dissection (George 1973) along middle levels of
/// breadth-first searches from one end of the graph to the other (George and Liu 1981, chapter 8),
/// until parts have at most so many unknowns; those by approximate minimum degrees (Amestoy et al.
/// 1996), which can't be asked to stop. Dissecting charts costs more than it saves (1.2 million
/// triangles: 15 s for 12), so that the default is large: some .3 s of minimum degrees.
STIPPLEFILTERSCORE_EXPORT Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>
eliminationOrder(const Eigen::SparseMatrix<double>& lower, const Stop& stop = {},
  std::size_t largestPart = 1048576);
}

#endif
