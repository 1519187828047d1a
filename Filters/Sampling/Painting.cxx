// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Painting.h"

#include <cmath>
#include <limits>
#include <unordered_set>

namespace stipple
{
namespace
{
/// The nearest place to p on the triangle (a, b, c): its foot in the plane if that is inside, else
/// on an edge.
Vec3 nearestOnTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c)
{
  const Vec3 normal = (b - a).cross(c - a);
  const double squared = normal.squaredNorm();
  if (squared > 0)
  {
    const Vec3 foot = p - normal * (normal.dot(p - a) / squared);
    const auto left = [&](const Vec3& q, const Vec3& r) {
      return (r - q).cross(foot - q).dot(normal) >= 0.;
    };
    if (left(a, b) && left(b, c) && left(c, a))
    {
      return foot;
    }
  }
  Vec3 best = nearestOnSegment(p, a, b);
  for (const Vec3& other : { nearestOnSegment(p, b, c), nearestOnSegment(p, c, a) })
  {
    best = (other - p).squaredNorm() < (best - p).squaredNorm() ? other : best;
  }
  return best;
}

/// Paints the pixels that a face owns.
void paintFace(const AtlasSurface& surface, const ControlImage& image, int face, const Vec3& centre,
  const BrushStroke& stroke, PaintLayer& layer)
{
  const int chart = surface.faceChart[face];
  const int index = face - surface.chartBegin[chart];
  const Vec2& a = surface.cornerUV(face, 0);
  const Vec2& b = surface.cornerUV(face, 1);
  const Vec2& c = surface.cornerUV(face, 2);
  if (orient2(a, b, c) == 0.)
  {
    return;
  }
  const PixelBox box = image.pixelsAround(a, b, c);
  for (int y = box.yBegin; y < box.yEnd; ++y)
  {
    for (int x = box.xBegin; x < box.xEnd; ++x)
    {
      const int pixel = y * image.width + x;
      if (image.faceIndex[pixel] != index)
      {
        continue;
      }
      double weight = 1;
      if (stroke.radius > 0)
      {
        const Vec3 bary = clampedBarycentric(barycentric(image.centre(pixel), a, b, c));
        weight = brushWeight((surface.position(face, bary) - centre).squaredNorm(), stroke.radius);
      }
      const auto change = static_cast<float>(weight * stroke.strength);
      if (change > 0)
      {
        layer.offset[pixel] += change;
      }
      else if (change < 0)
      {
        layer.factor[pixel] *= 1.f + change;
        layer.offset[pixel] *= 1.f + change;
      }
      else if (stroke.strength == 0)
      {
        const auto kept = static_cast<float>(1 - weight);
        layer.factor[pixel] = 1.f + kept * (layer.factor[pixel] - 1.f);
        layer.offset[pixel] *= kept;
      }
    }
  }
}
}

int nearestFace(const TriangleSurface& surface, const Vec3& position, Vec3& place)
{
  int nearest = -1;
  double best = std::numeric_limits<double>::max();
  for (int f = 0; f < surface.numberOfFaces(); ++f)
  {
    const Vec3& a = surface.point(f, 0);
    const Vec3& b = surface.point(f, 1);
    const Vec3& c = surface.point(f, 2);
    // The distance to the triangle's box is cheap and mostly enough.
    const Vec3 low = a.cwiseMin(b).cwiseMin(c);
    const Vec3 high = a.cwiseMax(b).cwiseMax(c);
    if ((position.cwiseMax(low).cwiseMin(high) - position).squaredNorm() >= best)
    {
      continue;
    }
    const Vec3 q = nearestOnTriangle(position, a, b, c);
    const double squared = (q - position).squaredNorm();
    if (squared < best)
    {
      best = squared;
      nearest = f;
      place = q;
    }
  }
  return nearest;
}

void paint(const AtlasSurface& surface, const std::vector<ControlImage>& images,
  const BrushStroke& stroke, const std::vector<char>& walls, std::vector<PaintLayer>& layers)
{
  Vec3 centre;
  const int first = nearestFace(surface, stroke.position, centre);
  if (first < 0)
  {
    return;
  }
  const auto goesAcross = [&](int halfedge) {
    if (stroke.radius == 0)
    {
      return walls.empty() || !walls[static_cast<std::size_t>(halfedge)];
    }
    const int face = halfedge / 3;
    const int k = halfedge % 3;
    const Vec3 near =
      nearestOnSegment(centre, surface.point(face, k), surface.point(face, (k + 1) % 3));
    return (near - centre).norm() < stroke.radius;
  };
  std::vector<int> front = { first };
  std::unordered_set<int> reached = { first };
  while (!front.empty())
  {
    const int face = front.back();
    front.pop_back();
    const int chart = surface.faceChart[face];
    PaintLayer& layer = layers[chart];
    if (layer.factor.empty())
    {
      layer.factor.assign(images[chart].numberOfPixels(), 1.f);
      layer.offset.assign(images[chart].numberOfPixels(), 0.f);
    }
    paintFace(surface, images[chart], face, centre, stroke, layer);
    for (int k = 0; k < 3; ++k)
    {
      const int h = 3 * face + k;
      const int twin = surface.twin[h];
      if (twin >= 0 && goesAcross(h) && reached.insert(twin / 3).second)
      {
        front.push_back(twin / 3);
      }
    }
  }
}
}
