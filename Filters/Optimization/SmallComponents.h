// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Components of few vertices: moves may gather these on one side, where they shrink to a point.
#ifndef stipple_SmallComponents_h
#define stipple_SmallComponents_h

#include "MeshEdit.h"
#include "StippleFiltersOptimizationModule.h"

#include <vector>

namespace stipple
{
/// Watches the components in which a one-ring is most of what there is. One that loses area is put
/// back where it was, and rests from then on.
class STIPPLEFILTERSOPTIMIZATION_EXPORT SmallComponents
{
public:
  /// Borrows the mesh.
  explicit SmallComponents(const OptimizedMesh& mesh);

  /// Whether a vertex must not move any more.
  bool rests(Vertex v) const { return !this->Rests.empty() && this->Rests[v] != 0; }
  /// Before a round of moves: notes the places.
  void note();
  /// After it: puts back what has lost too much area.
  void restore(MeshEdit& edit);

private:
  struct Component
  {
    std::vector<Vertex> vertices; ///< that are free on the surface
    std::vector<Face> faces;
    std::vector<SurfacePoint> before;
    double area = 0; ///< at the beginning
    bool rests = false;
  };
  void add(const std::vector<Vertex>& vertices);
  double areaOf(const Component& component) const;

  const OptimizedMesh& Mesh;
  std::vector<Component> Components;
  ElementArray<Vertex, char> Rests; // empty without small components
};
}

#endif
