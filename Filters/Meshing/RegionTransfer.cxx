// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RegionTransfer.h"

#include "RegionArrays.h"

#include "vtkAbstractArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPolyData.h"

#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace stipple
{
namespace
{
/// The cells of a mesh by their edges.
class CellsByEdge
{
public:
  explicit CellsByEdge(vtkCellArray* cells)
    : Cells(cells)
  {
    for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
    {
      this->forEachEdge(
        cell, [&](vtkIdType a, vtkIdType b) { this->CellOf[key(a, b)] = static_cast<int>(cell); });
    }
  }
  /// The cell to the left of the way from a to b, or -1.
  int cell(vtkIdType a, vtkIdType b) const
  {
    const auto found = this->CellOf.find(key(a, b));
    return found == this->CellOf.end() ? -1 : found->second;
  }
  template <typename Visit>
  void forEachEdge(vtkIdType cell, const Visit& visit) const
  {
    vtkIdType size;
    const vtkIdType* ids;
    this->Cells->GetCellAtId(cell, size, ids);
    for (vtkIdType k = 0; k < size; ++k)
    {
      visit(ids[k], ids[(k + 1) % size]);
    }
  }
  static std::uint64_t key(vtkIdType a, vtkIdType b)
  {
    return (static_cast<std::uint64_t>(a) << 32) | static_cast<std::uint64_t>(b);
  }

private:
  vtkCellArray* Cells;
  std::unordered_map<std::uint64_t, int> CellOf;
};

/// For every cell of the mesh a face of the surface in the cell's region; -1 for those of
/// components without borders, which lie in one region.
std::vector<int> facesInRegions(const Atlas& atlas, vtkPolyData* lines, vtkCellArray* polygons)
{
  const CellsByEdge cells(polygons);
  std::vector<int> face(static_cast<std::size_t>(polygons->GetNumberOfCells()), -1);
  std::vector<int> next;
  const auto reach = [&](int cell, int itsFace) {
    if (cell >= 0 && face[cell] < 0)
    {
      face[cell] = itsFace;
      next.push_back(cell);
    }
  };
  std::unordered_set<std::uint64_t> walls;
  vtkDataArray* backbones = lines->GetCellData()->GetArray("BackboneId");
  for (vtkIdType line = 0; line < lines->GetNumberOfLines(); ++line)
  {
    const auto b = static_cast<std::size_t>(backbones->GetComponent(line, 0));
    if (atlas.graph().backbones[b].keep == Keep::Nothing)
    {
      continue;
    }
    const BackboneTrace& trace = atlas.traces()[b];
    vtkIdType size;
    const vtkIdType* ids;
    lines->GetLines()->GetCellAtId(line, size, ids);
    for (vtkIdType i = 1; i < size; ++i)
    {
      const vtkIdType from = ids[i - 1];
      const vtkIdType to = ids[i];
      walls.insert({ CellsByEdge::key(from, to), CellsByEdge::key(to, from) });
      // The label is the same all along a side: a third region would end the backbone.
      for (const int side : { 0, 1 })
      {
        if (!trace.halfedge[side].empty())
        {
          reach(side == 0 ? cells.cell(from, to) : cells.cell(to, from),
            trace.halfedge[side].front() / 3);
        }
      }
    }
  }
  while (!next.empty())
  {
    const int cell = next.back();
    next.pop_back();
    cells.forEachEdge(cell, [&](vtkIdType a, vtkIdType b) {
      if (walls.count(CellsByEdge::key(a, b)) == 0)
      {
        reach(cells.cell(b, a), face[cell]);
      }
    });
  }
  return face;
}
}

void transferRegions(const Atlas& atlas, vtkPolyData* lines, vtkPolyData* mesh)
{
  const std::string& name = atlas.graph().regionArray;
  vtkAbstractArray* labels =
    name.empty() ? nullptr : mesh->GetCellData()->GetAbstractArray(name.c_str());
  if (!labels)
  {
    return;
  }
  setRegionArrayName(mesh, name);
  const AtlasSurface& surface = atlas.surface();
  const std::vector<int> faces = facesInRegions(atlas, lines, mesh->GetPolys());
  for (std::size_t cell = 0; cell < faces.size(); ++cell)
  {
    if (const Face face(faces[cell]); face.valid())
    {
      vtkPolyData* chart = surface.charts[surface.faceChart[face].index()];
      labels->SetTuple(static_cast<vtkIdType>(cell), surface.chartCell(face),
        chart->GetCellData()->GetAbstractArray(name.c_str()));
    }
  }
}
}
