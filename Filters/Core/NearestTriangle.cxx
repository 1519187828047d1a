// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "NearestTriangle.h"

#include "TriangleDistance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace stipple
{
namespace
{
constexpr double SameDistance = 1e-12; ///< squared distances are as good as equal, over themselves
}

struct NearestTriangle::Node
{
  Vec3 low;
  Vec3 high;
  int begin; ///< of its triangles in Order
  int end;
  int child; ///< the first of two; -1: a leaf

  double squaredDistance(const Vec3& p) const
  {
    return (this->low - p).cwiseMax(p - this->high).cwiseMax(0.).squaredNorm();
  }
};

struct NearestTriangle::Tree
{
  std::vector<int> Order;
  std::vector<Node> Nodes;
};

NearestTriangle::NearestTriangle(const TriangleSurface& surface)
  : Surface(surface)
  , Boxes(std::make_unique<Tree>())
{
  constexpr int LargestLeaf = 4;
  std::vector<int>& order = this->Boxes->Order;
  std::vector<Node>& nodes = this->Boxes->Nodes;
  std::vector<Vec3> middle;
  for (const Face f : surface.faces())
  {
    middle.push_back(surface.position(f, Vec3::Constant(1. / 3.)));
  }
  order.resize(middle.size());
  std::iota(order.begin(), order.end(), 0);
  nodes.push_back({ Vec3::Zero(), Vec3::Zero(), 0, surface.numberOfFaces(), -1 });
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    Node node = nodes[i];
    node.low = Vec3::Constant(std::numeric_limits<double>::infinity());
    node.high = -node.low;
    for (int k = node.begin; k < node.end; ++k)
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        node.low = node.low.cwiseMin(surface.point(order[k], corner));
        node.high = node.high.cwiseMax(surface.point(order[k], corner));
      }
    }
    if (node.end - node.begin > LargestLeaf)
    {
      int axis = 0;
      (node.high - node.low).maxCoeff(&axis);
      const int half = node.begin + (node.end - node.begin) / 2;
      std::nth_element(order.begin() + node.begin, order.begin() + half, order.begin() + node.end,
        [&](int a, int b) { return middle[a][axis] < middle[b][axis]; });
      node.child = static_cast<int>(nodes.size());
      nodes.push_back({ Vec3::Zero(), Vec3::Zero(), node.begin, half, -1 });
      nodes.push_back({ Vec3::Zero(), Vec3::Zero(), half, node.end, -1 });
    }
    nodes[i] = node;
  }
}

NearestTriangle::~NearestTriangle() = default;

double NearestTriangle::squaredDistance(const Vec3& p, int face) const
{
  return squaredDistanceToTriangle(
    p, this->Surface.point(face, 0), this->Surface.point(face, 1), this->Surface.point(face, 2));
}

bool NearestTriangle::isBelow(const Vec3& p, int face, int other) const
{
  if (other < 0)
  {
    return true;
  }
  const auto height = [&](int f) {
    return std::abs(this->Surface.faceNormal(f).dot(p - this->Surface.point(f, 0)));
  };
  const double a = height(face);
  const double b = height(other);
  return a != b ? a > b : face < other;
}

NearestTriangle::Hit NearestTriangle::find(const Vec3& p, int hint, double enough) const
{
  const std::vector<Node>& nodes = this->Boxes->Nodes;
  Hit hit = { hint,
    hint < 0 ? std::numeric_limits<double>::infinity() : this->squaredDistance(p, hint) };
  struct Open
  {
    int node;
    double squared;
  };
  std::array<Open, 64> stack; // the halves of 2^31 triangles
  int open = 0;
  stack[open++] = { 0, 0. };
  while (open > 0 && hit.squaredDistance > enough)
  {
    const Open next = stack[--open];
    const Node& node = nodes[next.node];
    if (next.squared > (1. + SameDistance) * hit.squaredDistance)
    {
      continue;
    }
    if (node.child < 0)
    {
      for (int k = node.begin; k < node.end; ++k)
      {
        const int face = this->Boxes->Order[k];
        const double squared = this->squaredDistance(p, face);
        if (squared <= (1. + SameDistance) * hit.squaredDistance)
        {
          const bool isIt =
            squared < (1. - SameDistance) * hit.squaredDistance || this->isBelow(p, face, hit.face);
          hit = { isIt ? face : hit.face, std::min(squared, hit.squaredDistance) };
        }
      }
      continue;
    }
    const Open first = { node.child, nodes[node.child].squaredDistance(p) };
    const Open second = { node.child + 1, nodes[node.child + 1].squaredDistance(p) };
    const bool firstNearer = first.squared <= second.squared;
    stack[open++] = firstNearer ? second : first;
    stack[open++] = firstNearer ? first : second;
  }
  return hit;
}
}
