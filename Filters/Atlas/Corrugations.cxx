// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Corrugations.h"

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
    , Left(this->Across, edge)
    , Right(this->Across, surface.twin[edge])
  {
  }

  double pitch()
  {
    // Most are found near by, and far away there may be very many edges.
    for (int k = Halvings; k >= 0; --k)
    {
      const double reach = this->Options.widestPitch / (1 << k);
      this->Left.follow(this->Across, reach);
      this->Right.follow(this->Across, reach);
      if (const double result = this->pitchWithin(); result < None)
      {
        return result;
      }
    }
    return None;
  }

private:
  static constexpr int Halvings = 6;
  static constexpr int FewestTurns = 6;

  struct Event
  {
    double distance;
    double angle; ///< in the direction from the right to the left
    bool isLeft;
  };

  double pitchWithin() const
  {
    std::vector<Event> events;
    for (const Turn& t : this->Left.turns())
    {
      events.push_back({ t.distance, t.angle, true });
    }
    for (const Turn& t : this->Right.turns())
    {
      events.push_back({ t.distance, -t.angle, false });
    }
    std::sort(events.begin(), events.end(),
      [](const Event& a, const Event& b) { return a.distance < b.distance; });
    const double bound = 0.5 * this->Options.angle * Pi / 180;
    struct Side
    {
      double turned = 0; // from the edge on
      int turns = 0;     // that count
      double last = 0;   // distance of the last of them
    };
    Side left;
    Side right;
    double moment = 0;
    for (const Event& e : events)
    {
      Side& side = e.isLeft ? left : right;
      side.turned += e.angle;
      const double direction = e.isLeft ? this->Own + left.turned : -right.turned;
      if (direction < std::min(0., this->Own) - bound ||
        direction > std::max(0., this->Own) + bound)
      {
        return None;
      }
      moment += e.angle * e.distance;
      if (std::abs(e.angle) >= std::max(2. * bound, 0.5 * std::abs(this->Own)))
      {
        ++side.turns;
        side.last = e.distance;
      }
      // The mean over so far of what the curve has turned by is that of each turn, for the part of
      // the way that is behind it.
      const double whole = this->Own + left.turned + right.turned - moment / e.distance;
      const int turns = left.turns + right.turns;
      if (left.turns > 0 && right.turns > 0 && turns >= FewestTurns && std::abs(whole) < bound)
      {
        return 2. * (left.last + right.last) / turns; // a ridge and a groove
      }
    }
    return None;
  }

  const CorrugationOptions& Options;
  const SurfaceSection Across;
  const double Own;
  SurfaceSection::Walk Left;
  SurfaceSection::Walk Right;
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
    std::vector<std::pair<double, double>> edges; // pitches, with lengths
    double whole = 0;
    for (int i = 0; i < backbone.numberOfSegments(); ++i)
    {
      const Halfedge h =
        findHalfedge(surface, first, Vertex(backbone.points[i]), Vertex(backbone.segmentEnd(i)));
      edges.emplace_back(pitchAt(surface, normals, h, options), surface.edgeLength(h));
      whole += edges.back().second;
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
