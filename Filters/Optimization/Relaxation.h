// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Geometry optimisation (paper 4.3): where a vertex should go, from its one-ring. Nothing moves
// yet.
#ifndef stipple_Relaxation_h
#define stipple_Relaxation_h

#include "OptimizedMesh.h"
#include "StippleFiltersOptimizationModule.h"
#include "Tuning.h"

#include <algorithm>
#include <cmath>

namespace stipple
{
/// What Lloyd's steps of a triangle's three vertices need to know of it.
struct FaceMeasure
{
  Vec3 normal = Vec3::Zero();
  double square = 0;    ///< of twice the area
  double twiceArea = 0; ///< of the surface under the triangle; 0 if it is degenerate
};

/// Those of all triangles, as they were at the last update.
class STIPPLEFILTERSOPTIMIZATION_EXPORT FaceMeasures
{
public:
  void update(const OptimizedMesh& mesh);
  const FaceMeasure& operator[](Face f) const { return this->Measures[f]; }

private:
  ElementArray<Face, FaceMeasure> Measures;
};

/// To the centroid, under the wanted density, of the vertex's Voronoi cell: Lloyd's step. The cell
/// is pieced together from the circumcentres of the triangles about the vertex, each in its own
/// plane. Cells have equal shares of the density where the centroids are those of its square. Cells
/// end at creases and boundaries; in a mesh that is not Delaunay, at the one-ring.
STIPPLEFILTERSOPTIMIZATION_EXPORT Vec3 lloydStep(
  const OptimizedMesh& mesh, const FaceMeasures& measures, Vertex v, bool isDelaunay);
/// The same for one vertex, in a mesh that is Delaunay.
STIPPLEFILTERSOPTIMIZATION_EXPORT Vec3 lloydStep(const OptimizedMesh& mesh, Vertex v);

/// A step bent towards the ridge beside v, if there is one that is no backbone: unmarked edges and
/// thin rims keep vertices then.
STIPPLEFILTERSOPTIMIZATION_EXPORT Vec3 towardsRidges(
  const OptimizedMesh& mesh, Vertex v, const Vec3& step);

/// The paper's weighted Laplacian: w_i = (A_i cot alpha_i + A_{i-1} cot beta_i) / sum of A, with
/// areas in space, or with the integrals of the wanted density over the triangles.
STIPPLEFILTERSOPTIMIZATION_EXPORT Vec3 laplacianStep(
  const OptimizedMesh& mesh, Vertex v, bool weightedByDensity);

/// To the middle of the neighbours.
STIPPLEFILTERSOPTIMIZATION_EXPORT Vec3 stepToMiddle(const OptimizedMesh& mesh, Vertex v);

STIPPLEFILTERSOPTIMIZATION_EXPORT double meanEdgeLength(const OptimizedMesh& mesh, Vertex v);

/// Lengths of edges that the density wants: those of a lattice of as many vertices as the mesh.
class STIPPLEFILTERSOPTIMIZATION_EXPORT VertexSpacing
{
public:
  /// Borrows the mesh.
  explicit VertexSpacing(const OptimizedMesh& mesh);
  double atUnitDensity() const { return this->AtUnitDensity; }
  double at(Vertex v) const { return this->AtUnitDensity / std::sqrt(this->Mesh.density(v)); }
  /// So many spacings, as they are without fine regions, but no farther than what shows on the
  /// surface as a whole.
  double farthest(Vertex v, double share) const
  {
    return std::min(share * this->at(v) / this->Mesh.fineness(v), this->Visible);
  }
  /// The smallest angle (radians) that triangles may have for coming so much nearer to the surface
  /// at v: as far as farthest(v, share) is worth any that are not hopeless.
  double poorestAngle(Vertex v, double share, double nearer) const
  {
    return std::max(
      Tuning::HopelessAngle, (1. - nearer / this->farthest(v, share)) * Tuning::PoorFeatureAngle);
  }

private:
  const OptimizedMesh& Mesh;
  double AtUnitDensity;
  double Visible;
};

/// length > share * meanEdgeLength(mesh, v), at less cost where it is not.
STIPPLEFILTERSOPTIMIZATION_EXPORT bool exceedsEdges(
  const OptimizedMesh& mesh, Vertex v, double length, double share);

/// Lloyd's step of a vertex that slides on a backbone, with the backbone held (constrained
/// centroidal Voronoi tessellation, Du, Gunzburger and Ju 2003): how far it goes along. So vertices
/// of two backbones that are one edge apart come to lie between one another's. Where the
/// backbones are so close that cells are cut off by them, to the middle of the neighbours. No
/// farther than 0.4 of the way to a neighbour on the backbone, and no nearer to one than an eighth
/// of the way between both.
STIPPLEFILTERSOPTIMIZATION_EXPORT double lloydSlide(
  const OptimizedMesh& mesh, const FaceMeasures& measures, Vertex v);

/// New arc lengths for the vertices on those sharp and boundary backbones that have a 1, which even
/// out their spacing under the wanted density, from one fixed vertex to the next at once. Others
/// keep theirs. No vertex goes farther than 0.4 of the way to its neighbour.
STIPPLEFILTERSOPTIMIZATION_EXPORT void relaxBackbones(const OptimizedMesh& mesh,
  const std::vector<char>& which, ElementArray<Vertex, double>& arcLength);
}

#endif
