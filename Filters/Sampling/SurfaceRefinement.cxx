// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceRefinement.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace stipple
{
namespace
{
std::uint64_t edgeKey(int p, int q)
{
  const auto low = static_cast<std::uint64_t>(std::min(p, q));
  return low << 32 | static_cast<std::uint64_t>(std::max(p, q));
}

/// Points in the middle of edges, by the edge's ends; one for all triangles that share it.
class Middles
{
public:
  explicit Middles(std::size_t numberOfPoints)
    : IsEnd(numberOfPoints, 0)
  {
  }
  bool empty() const { return this->Middle.empty(); }
  std::size_t size() const { return this->Middle.size(); }
  /// True if the edge had none.
  bool add(int p, int q, int middle)
  {
    this->IsEnd[p] = this->IsEnd[q] = 1;
    return this->Middle.try_emplace(edgeKey(p, q), middle).second;
  }
  /// -1 if there is none.
  int of(int p, int q) const
  {
    if (this->IsEnd[p] == 0 || this->IsEnd[q] == 0)
    {
      return -1;
    }
    const auto found = this->Middle.find(edgeKey(p, q));
    return found == this->Middle.end() ? -1 : found->second;
  }

private:
  std::vector<char> IsEnd; // by point: has an edge with a middle
  std::unordered_map<std::uint64_t, int> Middle;
};

class Splitter
{
public:
  Splitter(RefinedSurface& current, std::vector<char>& isSettled, const Middles& middles)
    : Current(current)
    , IsSettled(isSettled)
    , Middle(middles)
  {
    // Inside, an edge with a middle makes two triangles more.
    const std::size_t most = current.triangles.size() + 2 * middles.size();
    this->Next.triangles.reserve(most);
    this->Next.uv.reserve(most);
    this->Next.face.reserve(most);
    this->NextIsSettled.reserve(most);
  }

  void split(int t)
  {
    const Triangle& p = this->Current.triangles[t];
    const std::array<Vec2, 3>& uv = this->Current.uv[t];
    this->Face = this->Current.face[t];
    std::array<int, 3> middle;
    std::array<Vec2, 3> middleUV;
    int marked = 0;
    for (int k = 0; k < 3; ++k)
    {
      middle[k] = this->Middle.of(p[k], p[(k + 1) % 3]);
      middleUV[k] = 0.5 * (uv[k] + uv[(k + 1) % 3]);
      marked += middle[k] >= 0;
    }
    // Turn the triangle so that an only marked edge, or an only unmarked one, is edge 0.
    int first = 0;
    while ((marked == 1 && middle[first] < 0) || (marked == 2 && middle[first] >= 0))
    {
      ++first;
    }
    const std::array<int, 3> k = { first, (first + 1) % 3, (first + 2) % 3 };
    const auto corner = [&](int i) { return Corner{ p[k[i]], uv[k[i]] }; };
    const auto mid = [&](int i) { return Corner{ middle[k[i]], middleUV[k[i]] }; };
    switch (marked)
    {
      case 0:
        this->add(corner(0), corner(1), corner(2));
        this->NextIsSettled.back() = 1;
        break;
      case 1:
        this->add(corner(0), mid(0), corner(2));
        this->add(mid(0), corner(1), corner(2));
        break;
      case 2: // edges 1 and 2: what is left of corner 2 is a quadrilateral, cut by a diagonal
        this->add(mid(2), mid(1), corner(2));
        this->add(corner(0), mid(1), mid(2));
        this->add(corner(0), corner(1), mid(1));
        break;
      default:
        this->add(corner(0), mid(0), mid(2));
        this->add(mid(0), corner(1), mid(1));
        this->add(mid(2), mid(1), corner(2));
        this->add(mid(0), mid(1), mid(2));
    }
  }

  void finish()
  {
    this->Current.triangles.swap(this->Next.triangles);
    this->Current.uv.swap(this->Next.uv);
    this->Current.face.swap(this->Next.face);
    this->IsSettled.swap(this->NextIsSettled);
  }

private:
  struct Corner
  {
    int point;
    Vec2 uv;
  };
  void add(const Corner& a, const Corner& b, const Corner& c)
  {
    this->Next.triangles.push_back({ a.point, b.point, c.point });
    this->Next.uv.push_back({ a.uv, b.uv, c.uv });
    this->Next.face.push_back(this->Face);
    this->NextIsSettled.push_back(0);
  }
  RefinedSurface& Current;
  std::vector<char>& IsSettled;
  const Middles& Middle;
  RefinedSurface Next;
  std::vector<char> NextIsSettled;
  int Face = -1;
};

/// By edge of a triangle.
using EdgeMarks = std::array<bool, 3>;

/// Which edges of triangles that are not settled are to be halved.
std::vector<EdgeMarks> longEdges(const AtlasSurface& surface,
  const std::vector<ControlImage>& images, const RefinedSurface& refined,
  const std::vector<char>& isSettled,
  const std::function<bool(const Vec3&, const Vec3&)>& isTooLong)
{
  std::vector<EdgeMarks> marks(refined.triangles.size());
  constexpr vtkIdType Grain = 1024;
  vtkSMPTools::For(0, refined.numberOfTriangles(), Grain, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType t = begin; t < end; ++t)
    {
      const Triangle& p = refined.triangles[t];
      const ControlImage& image = images[surface.faceChart[refined.face[t]]];
      const Vec2 toPixel(image.width / image.extent.x(), image.height / image.extent.y());
      for (int k = 0; k < 3; ++k)
      {
        const int next = (k + 1) % 3;
        const Vec2 e = (refined.uv[t][next] - refined.uv[t][k]).cwiseProduct(toPixel);
        marks[t][k] = isSettled[t] == 0 && e.norm() > 2. &&
          isTooLong(refined.points[p[k]], refined.points[p[next]]);
      }
    }
  });
  return marks;
}
}

RefinedSurface refine(
  const AtlasSurface& surface, const std::vector<ControlImage>& images, double longest)
{
  return refine(
    surface, images, [longest](const Vec3& p, const Vec3& q) { return (q - p).norm() > longest; });
}

RefinedSurface refine(const AtlasSurface& surface, const std::vector<ControlImage>& images,
  const std::function<bool(const Vec3&, const Vec3&)>& isTooLong)
{
  RefinedSurface result;
  result.points = surface.points;
  result.triangles = surface.triangles;
  for (int f = 0; f < surface.numberOfFaces(); ++f)
  {
    result.uv.push_back({ surface.cornerUV(f, 0), surface.cornerUV(f, 1), surface.cornerUV(f, 2) });
    result.face.push_back(f);
  }
  // Of those, no edge was too long when it was asked.
  std::vector<char> isSettled(result.triangles.size(), 0);
  for (;;)
  {
    const std::vector<EdgeMarks> tooLong = longEdges(surface, images, result, isSettled, isTooLong);
    Middles middles(result.points.size());
    for (int t = 0; t < result.numberOfTriangles(); ++t)
    {
      const Triangle& p = result.triangles[t];
      for (int k = 0; k < 3; ++k)
      {
        const int q = p[(k + 1) % 3];
        if (tooLong[t][k] && middles.add(p[k], q, static_cast<int>(result.points.size())))
        {
          const Vec3 middle = 0.5 * (result.points[p[k]] + result.points[q]);
          result.points.push_back(middle);
        }
      }
    }
    if (middles.empty())
    {
      return result;
    }
    Splitter splitter(result, isSettled, middles);
    for (int t = 0; t < result.numberOfTriangles(); ++t)
    {
      splitter.split(t);
    }
    splitter.finish();
  }
}

std::vector<PixelPlace> placePixels(
  const AtlasSurface& surface, const RefinedSurface& refined, int chart, const ControlImage& image)
{
  const int firstFace = surface.chartBegin[chart];
  // The first triangle of each of the chart's faces, and where the last ends.
  std::vector<int> first;
  auto from = std::lower_bound(refined.face.begin(), refined.face.end(), firstFace);
  for (int face = firstFace; face <= surface.chartBegin[chart + 1]; ++face)
  {
    from = std::find_if(from, refined.face.end(), [face](int f) { return f >= face; });
    first.push_back(static_cast<int>(from - refined.face.begin()));
  }
  std::vector<PixelPlace> places(static_cast<std::size_t>(image.numberOfPixels()));
  // How far inside its best triangle a pixel is so far: who owns a pixel is decided with rounded
  // coordinates, so that it may lie a little outside its face.
  std::vector<float> inside(places.size(), -1e30f);
  const auto offer = [&](int pixel, int triangle) {
    const auto& [a, b, c] = refined.uv[triangle];
    if (orient2(a, b, c) == 0.)
    {
      return;
    }
    const Vec3 bary = barycentric(image.centre(pixel), a, b, c);
    const auto least = static_cast<float>(bary.minCoeff());
    if (least > inside[pixel])
    {
      inside[pixel] = least;
      const Vec3 clamped = clampedBarycentric(bary);
      places[pixel].triangle = triangle;
      for (int k = 0; k < 3; ++k)
      {
        places[pixel].bary[k] = static_cast<float>(clamped[k]);
      }
    }
  };
  // Most faces are whole: that needs no search.
  for (int pixel = 0; pixel < image.numberOfPixels(); ++pixel)
  {
    const int face = image.faceIndex[pixel];
    if (face >= 0 && first[face + 1] - first[face] == 1)
    {
      offer(pixel, first[face]);
    }
  }
  for (std::size_t face = 0; face + 1 < first.size(); ++face)
  {
    if (first[face + 1] - first[face] == 1)
    {
      continue;
    }
    for (int t = first[face]; t < first[face + 1]; ++t)
    {
      const auto& [a, b, c] = refined.uv[t];
      const PixelBox box = image.pixelsAround(a, b, c);
      for (int y = box.yBegin; y < box.yEnd; ++y)
      {
        for (int x = box.xBegin; x < box.xEnd; ++x)
        {
          const int pixel = y * image.width + x;
          if (image.faceIndex[pixel] == static_cast<int>(face) && inside[pixel] < 0.f)
          {
            offer(pixel, t);
          }
        }
      }
    }
  }
  // A face without an area in the plane, or far from the pixel that was given to it.
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    if (places[i].triangle < 0)
    {
      places[i].triangle = first[std::max(0, image.faceIndex[i])];
    }
  }
  return places;
}
}
