// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The curve in which the plane across an edge's middle cuts the surface, and how it turns.
#ifndef stipple_SurfaceSection_h
#define stipple_SurfaceSection_h

#include "CutSurface.h"
#include "StippleFiltersAtlasModule.h"

namespace stipple
{
using FaceNormals = ElementArray<Face, Vec3>;

/// Of unit length. Sections pass each face many times.
STIPPLEFILTERSATLAS_EXPORT FaceNormals faceNormalsOf(const CutSurface& surface);

/// How a curve turns, by the distance along it from where it begins.
struct Turn
{
  double distance;
  double angle; ///< signed, radians
};

/// Borrows the surface and its normals.
class STIPPLEFILTERSATLAS_EXPORT SurfaceSection
{
public:
  enum class Ends
  {
    AtFeatures, ///< it goes no further than the next edge that is one, unless that is rounded off
    AtBoundaries
  };
  SurfaceSection(const CutSurface& surface, const FaceNormals& normals, Halfedge edge, Ends ends);

  /// Signed angle between the surface's normals in two faces, in the plane, radians.
  double turn(Face from, Face to) const;
  /// By how much it turns at the edge itself: from the right, the face of its twin, to the left.
  double ownTurn() const;

  /// One half of it, as far as it was followed.
  class STIPPLEFILTERSATLAS_EXPORT Walk
  {
  public:
    /// Into the face of a halfedge of the section's edge.
    Walk(const SurfaceSection& section, Halfedge edge);
    /// In the direction of the walk: of one to the right they have the other sign.
    const std::vector<Turn>& turns() const { return this->Turns; }
    /// Goes on to the next edge that it crosses; false if none is within that distance from where
    /// it begins.
    bool step(const SurfaceSection& section, double reach);
    /// Goes on to that distance.
    void follow(const SurfaceSection& section, double reach)
    {
      while (this->step(section, reach))
      {
      }
    }

  private:
    Halfedge Edge;
    Vec3 At;
    double Distance = 0;
    Halfedge Next; ///< of the face that it goes through next
    double Tail;   ///< heights of its ends
    double Head;
    bool HasEnded = false;
    std::vector<Turn> Turns;
  };

private:
  bool isEnd(Halfedge h) const
  {
    return this->Where == Ends::AtFeatures && this->Surface.isFeature(h) &&
      !this->Surface.isRounded(h);
  }
  double height(Vertex v) const { return (this->Surface.point(v) - this->Middle).dot(this->Along); }

  const CutSurface& Surface;
  const FaceNormals& NormalOf;
  const Halfedge Edge;
  const Ends Where;
  const Vec3 Middle;
  const Vec3 Along;
};
}

#endif
