// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SmallComponents.h"

#include <utility>

namespace stipple
{
namespace
{
constexpr std::size_t MostVertices = 30;
/// A component keeps this share of its area at least.
constexpr double LeastArea = 0.75;
}

SmallComponents::SmallComponents(OptimizedMesh& mesh)
  : Mesh(mesh)
{
  const int n = mesh.numberOfVertices();
  std::vector<char> isReached(n, 0);
  std::vector<int> vertices;
  for (int start = 0; start < n; ++start)
  {
    if (isReached[start])
    {
      continue;
    }
    vertices = { start };
    isReached[start] = 1;
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      mesh.forEachNeighbour(vertices[i], [&](int u) {
        if (!isReached[u])
        {
          isReached[u] = 1;
          vertices.push_back(u);
        }
      });
    }
    if (vertices.size() <= MostVertices)
    {
      this->add(vertices);
    }
  }
}

void SmallComponents::add(const std::vector<int>& vertices)
{
  this->Rests.resize(this->Mesh.numberOfVertices(), 0);
  Component component;
  for (int v : vertices)
  {
    this->Mesh.forEachFace(v, [&](int f) { component.faces.push_back(f); });
    if (this->Mesh.freedom(v) == Freedom::Surface)
    {
      component.vertices.push_back(v);
    }
  }
  makeUnique(component.faces);
  component.area = this->areaOf(component);
  this->Components.push_back(std::move(component));
}

double SmallComponents::areaOf(const Component& component) const
{
  double area = 0;
  for (int f : component.faces)
  {
    const auto t = this->Mesh.corners(f);
    area +=
      triangleArea(this->Mesh.position(t[0]), this->Mesh.position(t[1]), this->Mesh.position(t[2]));
  }
  return area;
}

void SmallComponents::note()
{
  for (Component& component : this->Components)
  {
    component.before.clear();
    for (int v : component.vertices)
    {
      component.before.push_back(this->Mesh.footing(v));
    }
  }
}

void SmallComponents::restore()
{
  for (Component& component : this->Components)
  {
    if (component.rests || this->areaOf(component) >= LeastArea * component.area)
    {
      continue;
    }
    component.rests = true;
    for (std::size_t i = 0; i < component.vertices.size(); ++i)
    {
      this->Mesh.put(component.vertices[i], component.before[i]);
      this->Rests[component.vertices[i]] = 1;
    }
  }
}
}
