// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Corrugations.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace stipple
{
namespace
{
constexpr double None = std::numeric_limits<double>::infinity();

/// How the surface turns to and fro on both sides of an edge.
class Profile
{
public:
  Profile(const CutSurface& surface, const FaceNormals& normals, Halfedge edge,
    const CorrugationOptions& options)
    : Options(options)
    , Across(surface, normals, edge, SurfaceSection::Ends::AtBoundaries)
    , Own(this->Across.ownTurn())
    , Left{ SurfaceSection::Walk(this->Across, edge), 1 }
    , Right{ SurfaceSection::Walk(this->Across, surface.twin[edge]), -1 }
  {
  }

  double pitch()
  {
    const double bound = 0.5 * this->Options.angle * Pi / 180;
    double moment = 0;
    for (Side* side = this->nearest(); side != nullptr; side = this->nearest())
    {
      const double distance = side->next().distance;
      const double angle = side->sign * side->next().angle; // from the right to the left
      ++side->passed;
      side->turned += angle;
      const double direction =
        side == &this->Left ? this->Own + this->Left.turned : -this->Right.turned;
      if (direction < std::min(0., this->Own) - bound ||
        direction > std::max(0., this->Own) + bound)
      {
        return None;
      }
      moment += angle * distance;
      if (std::abs(angle) >= std::max(2. * bound, 0.5 * std::abs(this->Own)))
      {
        ++side->turns;
        side->last = distance;
      }
      // The mean over so far of what the curve has turned by is that of each turn, for the part of
      // the way that is behind it.
      const double whole = this->Own + this->Left.turned + this->Right.turned - moment / distance;
      const int turns = this->Left.turns + this->Right.turns;
      if (this->Left.turns > 0 && this->Right.turns > 0 && turns >= FewestTurns &&
        std::abs(whole) < bound)
      {
        return 2. * (this->Left.last + this->Right.last) / turns; // a ridge and a groove
      }
    }
    return None;
  }

private:
  static constexpr int FewestTurns = 6;

  struct Side
  {
    SurfaceSection::Walk walk;
    int sign;
    std::size_t passed = 0; // edges of the walk
    double turned = 0;      // from the edge on
    int turns = 0;          // that count
    double last = 0;        // distance of the last of them

    const Turn& next() const { return this->walk.turns()[this->passed]; }
  };

  /// The side that crosses the nearest edge that was not passed yet. Most profiles are decided near
  /// by, and far away there may be very many edges: no side goes further than that.
  Side* nearest()
  {
    Side* result = nullptr;
    for (Side* side : { &this->Left, &this->Right })
    {
      const bool isThere = side->passed < side->walk.turns().size() ||
        side->walk.step(this->Across, this->Options.widestPitch);
      if (isThere && (result == nullptr || side->next().distance < result->next().distance))
      {
        result = side;
      }
    }
    return result;
  }

  const CorrugationOptions& Options;
  const SurfaceSection Across;
  const double Own;
  Side Left;
  Side Right;
};
}

double pitchAt(const CutSurface& surface, const FaceNormals& normals, Halfedge edge,
  const CorrugationOptions& options)
{
  return Profile(surface, normals, edge, options).pitch();
}

void measureCorrugations(
  const CutSurface& surface, const CorrugationOptions& options, FeatureGraph& graph)
{
  const bool areAny = std::any_of(graph.backbones.begin(), graph.backbones.end(),
    [](const Backbone& b) { return b.type == BackboneType::Sharp; });
  if (!areAny)
  {
    return;
  }
  const FaceNormals normals = faceNormalsOf(surface);
  const ElementArray<Vertex, Halfedge> first = surface.vertexHalfedges();
  for (Backbone& backbone : graph.backbones)
  {
    if (backbone.type != BackboneType::Sharp || backbone.keep != Keep::Nothing ||
      backbone.width > 0)
    {
      continue;
    }
    std::vector<std::pair<double, double>> edges(backbone.numberOfSegments()); // pitches, lengths
    constexpr vtkIdType Grain = 16;
    vtkSMPTools::For(0, backbone.numberOfSegments(), Grain, [&](vtkIdType begin, vtkIdType end) {
      for (int i = static_cast<int>(begin); i < static_cast<int>(end); ++i)
      {
        const Halfedge h =
          findHalfedge(surface, first, Vertex(backbone.points[i]), Vertex(backbone.segmentEnd(i)));
        edges[i] = { pitchAt(surface, normals, h, options), surface.edgeLength(h) };
      }
    });
    double whole = 0;
    for (const auto& [pitch, length] : edges)
    {
      whole += length;
    }
    std::sort(edges.begin(), edges.end());
    double sum = 0;
    for (const auto& [pitch, length] : edges)
    {
      sum += length;
      if (sum >= 0.5 * whole)
      {
        backbone.pitch = pitch < None ? pitch : 0.;
        break;
      }
    }
  }
}
}
