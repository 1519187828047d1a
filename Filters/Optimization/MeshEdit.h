// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The one way to change a mesh under optimisation: swaps and moves, which may be taken back.
#ifndef stipple_MeshEdit_h
#define stipple_MeshEdit_h

#include "FailedMoves.h"
#include "OptimizedMesh.h"
#include "StippleFiltersOptimizationModule.h"

namespace stipple
{
class STIPPLEFILTERSOPTIMIZATION_EXPORT MeshEdit
{
public:
  /// Borrows the mesh.
  explicit MeshEdit(OptimizedMesh& mesh)
    : Edited(mesh)
  {
  }
  const OptimizedMesh& mesh() const { return this->Edited; }

  /// From now on, only some vertices move, and edges are swapped only where one of their triangles
  /// has one of these; all, if there is no such array. What flip() and put() are told is done all
  /// the same.
  void restrictTo(ElementArray<Vertex, char> isMoving) { this->IsMoving = std::move(isMoving); }
  bool mayMove(Vertex v) const { return this->IsMoving.empty() || this->IsMoving[v] != 0; }
  bool maySwap(Edge e) const
  {
    if (this->IsMoving.empty())
    {
      return true;
    }
    const auto wing = this->Edited.wingVertices(e);
    return std::any_of(wing.begin(), wing.end(), [this](Vertex v) { return this->mayMove(v); });
  }

  /// Makes changes, and takes all of them back unless change() returns true; so does this.
  /// Attempts may be made within others.
  template <typename Change>
  bool attempt(const Change& change)
  {
    const std::size_t begin = this->Log.size();
    ++this->Depth;
    const bool isKept = change();
    --this->Depth;
    if (!isKept)
    {
      this->undo(begin);
    }
    if (this->Depth == 0)
    {
      this->Log.clear();
    }
    return isKept;
  }
  /// Puts a free vertex somewhere, if isBetter() with it there.
  template <typename IsBetter>
  bool tryPut(Vertex v, const SurfacePoint& there, const IsBetter& isBetter)
  {
    return this->mayMove(v) && this->attempt([&]() {
      this->note(v);
      static_cast<SurfacePoint&>(this->Edited.State[v]) = there;
      if (!isBetter())
      {
        return false;
      }
      this->Edited.put(v, there); // with the density there, which attempts do not ask for
      return true;
    });
  }
  /// Slides a vertex along its backbone, if isBetter() with it there.
  template <typename IsBetter>
  bool trySlide(Vertex v, double step, const IsBetter& isBetter)
  {
    return this->hasRoom(v, step) && this->attempt([&]() {
      this->slide(v, step);
      return isBetter();
    });
  }
  /// Pattern search, one size of it: a free vertex tries eight steps of that length in its tangent
  /// plane by tryStep(step); one on a backbone slides back and forth as long as isBetter().
  template <typename TryStep, typename IsBetter>
  void tryAround(Vertex v, double length, const TryStep& tryStep, const IsBetter& isBetter)
  {
    if (this->Edited.freedom(v) == Freedom::Backbone)
    {
      while (this->trySlide(v, length, isBetter) || this->trySlide(v, -length, isBetter))
      {
      }
    }
    else if (this->Edited.isFree(v))
    {
      for (const Vec3& step : this->stepsAround(v, length))
      {
        tryStep(step);
      }
    }
  }

  /// Steps of a length in the tangent plane, in eight directions.
  std::array<Vec3, 8> stepsAround(Vertex v, double length) const;

  /// Swaps an edge if it may be, and no second edge between two vertices, no fold and no degenerate
  /// triangle comes of it.
  bool swap(Edge e);
  /// Swaps an edge, that isSwappable() and keepsManifold(), whatever triangles come of it.
  void flip(Edge e);
  /// Puts a vertex, that isFree(), somewhere.
  void put(Vertex v, const SurfacePoint& there);

  /// Moves all vertices by steps of space (free ones) and to arc lengths (those on backbones), on
  /// all threads; not within an attempt. Where that makes a triangle unsound, the steps of its
  /// vertices are halved, at last refused, and set to zero.
  void moveAll(ElementArray<Vertex, Vec3>& step, const ElementArray<Vertex, double>& arcLength);

  /// Of improveByMove(): within the ring only, or not.
  FailedMoves<2>& failedMoves() { return this->Failed; }

private:
  struct Change
  {
    Edge flipped;       ///< or
    Vertex moved;       ///< from
    VertexState before; ///< there
  };
  void note(Vertex v);
  void undo(std::size_t begin);
  /// Never past half the way to its neighbours on the backbone.
  bool hasRoom(Vertex v, double step) const;
  void slide(Vertex v, double step);

  OptimizedMesh& Edited;
  std::vector<Change> Log; // of the attempts under way
  int Depth = 0;           // of attempts
  FailedMoves<2> Failed;
  ElementArray<Vertex, char> IsMoving;      // none: all are
  ElementArray<Vertex, VertexState> Before; // the last moveAll(); kept for its memory only
};
}

#endif
