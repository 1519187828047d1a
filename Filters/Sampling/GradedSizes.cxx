// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "GradedSizes.h"

#include "SurfaceRefinement.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace stipple
{
GradedSizes::GradedSizes(std::vector<SizeSource> sources, double slope)
  : Sources(std::move(sources))
  , Slope(slope)
{
  if (!this->Sources.empty())
  {
    this->Boxes.push_back(
      { Vec3::Zero(), Vec3::Zero(), 0, 0, static_cast<int>(this->Sources.size()), -1 });
    for (std::size_t i = 0; i < this->Boxes.size(); ++i)
    {
      this->split(static_cast<int>(i));
    }
  }
}

void GradedSizes::split(int i)
{
  Box& box = this->Boxes[i];
  box.low = box.high = this->Sources[box.begin].position;
  box.size = this->Sources[box.begin].size;
  for (int i = box.begin; i < box.end; ++i)
  {
    box.low = box.low.cwiseMin(this->Sources[i].position);
    box.high = box.high.cwiseMax(this->Sources[i].position);
    box.size = std::min(box.size, this->Sources[i].size);
  }
  if (box.end - box.begin <= 8)
  {
    return;
  }
  int axis = 0;
  (box.high - box.low).maxCoeff(&axis);
  const int begin = box.begin;
  const int end = box.end;
  const int middle = begin + (end - begin) / 2;
  std::nth_element(this->Sources.begin() + begin, this->Sources.begin() + middle,
    this->Sources.begin() + end, [axis](const SizeSource& a, const SizeSource& b) {
      return a.position[axis] < b.position[axis];
    });
  box.child = static_cast<int>(this->Boxes.size());
  this->Boxes.push_back({ Vec3::Zero(), Vec3::Zero(), 0, begin, middle, -1 });
  this->Boxes.push_back({ Vec3::Zero(), Vec3::Zero(), 0, middle, end, -1 });
}

double GradedSizes::at(const Vec3& place, double most) const
{
  if (this->Boxes.empty())
  {
    return most;
  }
  const auto bound = [&](const Box& box) {
    const Vec3 outside = (box.low - place).cwiseMax(place - box.high).cwiseMax(0.);
    return box.size + this->Slope * outside.norm();
  };
  std::array<int, 64> stack;
  int open = 0;
  stack[open++] = 0;
  while (open > 0)
  {
    const Box& box = this->Boxes[stack[--open]];
    if (bound(box) >= most)
    {
      continue;
    }
    if (box.child < 0)
    {
      for (int i = box.begin; i < box.end; ++i)
      {
        const SizeSource& s = this->Sources[i];
        most = std::min(most, s.size + this->Slope * (s.position - place).norm());
      }
      continue;
    }
    const bool firstNearer = bound(this->Boxes[box.child]) <= bound(this->Boxes[box.child + 1]);
    stack[open++] = firstNearer ? box.child + 1 : box.child;
    stack[open++] = firstNearer ? box.child : box.child + 1;
  }
  return most;
}

void forEachPixelSize(const AtlasSurface& surface, const std::vector<ControlImage>& images,
  const GradedSizes& sizes, const std::function<void(std::size_t, std::size_t, double)>& visit)
{
  const RefinedSurface refined = refine(surface, images, [&](const Vec3& p, const Vec3& q) {
    const double length = (p - q).norm();
    return length > sizes.smallest() && length > sizes.at(0.5 * (p + q), length);
  });
  std::vector<double> size(refined.points.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(size.size()), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType p = begin; p < end; ++p)
    {
      size[p] = sizes.at(refined.points[p], std::numeric_limits<double>::max());
    }
  });
  forEachChart(images.size(), [&](std::size_t c) {
    const auto places = placePixels(surface, refined, static_cast<int>(c), images[c]);
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      const Triangle& t = refined.triangles[places[i].triangle];
      const auto& bary = places[i].bary;
      visit(c, i, bary[0] * size[t[0]] + bary[1] * size[t[1]] + bary[2] * size[t[2]]);
    }
  });
}
}
