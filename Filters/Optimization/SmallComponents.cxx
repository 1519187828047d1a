// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SmallComponents.h"

#include "MeshRegion.h"
#include "Tuning.h"

#include <utility>

namespace stipple
{
SmallComponents::SmallComponents(const OptimizedMesh& mesh)
  : Mesh(mesh)
{
  ElementArray<Vertex, char> isReached(static_cast<std::size_t>(mesh.vertices().size()), 0);
  std::vector<Vertex> vertices;
  for (const Vertex start : mesh.vertices())
  {
    if (isReached[start])
    {
      continue;
    }
    vertices = { start };
    isReached[start] = 1;
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      mesh.forEachNeighbour(vertices[i], [&](Vertex u) {
        if (!isReached[u])
        {
          isReached[u] = 1;
          vertices.push_back(u);
        }
      });
    }
    if (vertices.size() <= Tuning::VerticesOfSmallComponent)
    {
      this->add(vertices);
    }
  }
}

void SmallComponents::add(const std::vector<Vertex>& vertices)
{
  this->Rests.resize(static_cast<std::size_t>(this->Mesh.vertices().size()), 0);
  Component component;
  component.vertices = filtered(vertices, [this](Vertex v) { return this->Mesh.isFree(v); });
  component.faces = facesAbout(this->Mesh, vertices);
  component.area = this->areaOf(component);
  this->Components.push_back(std::move(component));
}

double SmallComponents::areaOf(const Component& component) const
{
  double area = 0;
  for (const Face f : component.faces)
  {
    area += this->Mesh.faceArea(f);
  }
  return area;
}

void SmallComponents::note()
{
  for (Component& component : this->Components)
  {
    component.before.clear();
    for (const Vertex v : component.vertices)
    {
      component.before.push_back(this->Mesh.state(v));
    }
  }
}

void SmallComponents::restore(MeshEdit& edit)
{
  for (Component& component : this->Components)
  {
    if (component.rests || this->areaOf(component) >= Tuning::AreaOfSmallComponent * component.area)
    {
      continue;
    }
    component.rests = true;
    for (std::size_t i = 0; i < component.vertices.size(); ++i)
    {
      edit.put(component.vertices[i], component.before[i]);
      this->Rests[component.vertices[i]] = 1;
    }
  }
}
}
