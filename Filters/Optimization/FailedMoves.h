// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Vertices that no move helps, as long as they and what is about them are where they were.
#ifndef stipple_FailedMoves_h
#define stipple_FailedMoves_h

#include "OptimizedMesh.h"
#include "StippleFiltersOptimizationModule.h"

#include <array>
#include <cstdint>

namespace stipple
{
/// All that moves of a vertex depend on, as a number: the places of the vertex and of its
/// neighbours, in their order, and which of its edges are creases. Others have other numbers, but
/// for one in 2^64.
STIPPLEFILTERSOPTIMIZATION_EXPORT std::uint64_t fingerprintOf(const OptimizedMesh& mesh, Vertex v);

/// Of each vertex the last failure, in each of several ways to move it. It need not be told of
/// changes: attempts may be taken back, and the mesh exchanged.
template <std::size_t Ways>
class FailedMoves
{
public:
  bool contains(Vertex v, std::size_t way, std::uint64_t fingerprint) const
  {
    const auto i = static_cast<std::size_t>(v.index());
    return i < this->Last.size() && this->Last[v][way] == fingerprint;
  }
  void add(const OptimizedMesh& mesh, Vertex v, std::size_t way, std::uint64_t fingerprint)
  {
    this->Last.resize(static_cast<std::size_t>(mesh.vertices().size()));
    this->Last[v][way] = fingerprint;
  }

private:
  ElementArray<Vertex, std::array<std::uint64_t, Ways>> Last; // 0: none
};
}

#endif
