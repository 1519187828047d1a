// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "UnsteadyCreases.h"

#include "Relaxation.h"
#include "VertexStar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

namespace stipple
{
namespace
{
double angleBetween(const Vec3& a, const Vec3& b)
{
  return std::acos(std::clamp(a.dot(b), -1., 1.));
}
}

CreaseProfile::CreaseProfile(
  const Atlas& atlas, const SurfaceWalk& surfaceWalk, int backbone, double edgeLength)
{
  const BackboneTrace& trace = atlas.traces()[backbone];
  const double length = trace.length();
  const int places = std::max(3, static_cast<int>(length / (Tuning::StepAlongCrease * edgeLength)));
  const auto at = [&](double arcLength, int side) {
    const BackboneTrace::Place place = trace.locate(std::clamp(arcLength, 0., length));
    return SurfacePlace{ trace.face(place, side), trace.bary(place, side) };
  };
  std::vector<double> angles; // across
  for (int i = 0; i < places; ++i)
  {
    const double arcLength = (i + 0.5) / places * length;
    const double little = 0.25 * length / places;
    const Vec3 ahead = surfaceWalk.position(at(arcLength + little, 0)) -
      surfaceWalk.position(at(arcLength - little, 0));
    std::array<Vec3, 2> beside;
    std::array<Vec3, 2> away;
    for (int side = 0; side < 2; ++side)
    {
      const SurfacePlace from = at(arcLength, side);
      beside[side] = surfaceWalk.normal(from.face);
      const Vec3 across = (side == 0 ? 1. : -1.) * beside[side].cross(ahead).normalized();
      const Vec3 step = Tuning::ReachAcrossCrease * edgeLength * across;
      away[side] = surfaceWalk.normal(surfaceWalk.walk(from, step).face);
    }
    angles.push_back(angleBetween(away[0], away[1]));
    this->bend += angleBetween(beside[0], beside[1]) / places;
  }
  for (int i = 1; i + 1 < places; ++i)
  {
    this->unsteadiness +=
      std::abs(angles[i] - 0.5 * (angles[i - 1] + angles[i + 1])) / (places - 2);
  }
}

double CreaseProfile::depth() const
{
  return this->bend <= Tuning::SteepestUnsteady ? 0.5 * std::tan(0.5 * this->bend)
                                                : std::numeric_limits<double>::infinity();
}

namespace
{
/// Creases between which a triangle lies at its corners.
std::vector<int> creasesAbout(const OptimizedMesh& mesh, Face f)
{
  std::vector<int> result;
  for (const Halfedge corner : mesh.triangleCorners(f))
  {
    const auto add = [&](Halfedge h, const auto& turn) {
      for (const Halfedge first = h; !mesh.isCrease(mesh.edge(h));)
      {
        h = turn(h);
        if (h == first)
        {
          return; // none about the vertex
        }
      }
      result.push_back(mesh.crease(mesh.edge(h)).backbone);
    };
    if (!mesh.isFree(mesh.from(corner)))
    {
      add(corner, [&](Halfedge h) { return mesh.next(mesh.opposite(h)); });
      add(mesh.opposite(mesh.previous(corner)),
        [&](Halfedge h) { return mesh.opposite(mesh.previous(h)); });
    }
  }
  makeUnique(result);
  return result;
}
}

int giveUpUnsteadyCreases(OptimizedMesh& mesh, double tolerance, double poorAngle)
{
  const std::vector<Backbone>& backbones = mesh.atlas().graph().backbones;
  std::map<int, double> worth; // of the poor triangles of each, in spacings that edges may move
  for (const Face f : mesh.faces())
  {
    const double angle = faceQuality(mesh, f);
    if (angle >= poorAngle)
    {
      continue;
    }
    for (const int b : creasesAbout(mesh, f))
    {
      // What is rounded off was found by how steady it is.
      if (b >= 0 && backbones[b].type == BackboneType::Sharp &&
        backbones[b].keep == Keep::Nothing && backbones[b].width == 0)
      {
        worth[b] += tolerance * (1. - std::max(0., angle) / poorAngle);
      }
    }
  }
  const VertexSpacing spacing(mesh);
  std::vector<int> givenUp;
  for (const auto& [b, sum] : worth)
  {
    const OptimizedMesh::Chain& chain = mesh.chains()[b];
    const Vertex v = chain.front().vertex;
    const double perEdge = sum / static_cast<double>(chain.size() - 1);
    const CreaseProfile profile(mesh.atlas(), mesh.surfaceWalk(), b, spacing.at(v));
    if (!profile.isSteady() &&
      profile.depth() * spacing.at(v) <= spacing.farthest(v, std::min(tolerance, perEdge)))
    {
      givenUp.push_back(b);
    }
  }
  if (!givenUp.empty())
  {
    mesh.giveUp(givenUp);
  }
  return static_cast<int>(givenUp.size());
}
}
