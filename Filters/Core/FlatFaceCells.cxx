// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FlatFaceCells.h"

#include "TriangleSurface.h"
#include "UserArrays.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <cstddef>
#include <utility>

namespace stipple
{
void FlatFaceCells::add(std::vector<Piece> face)
{
  for (const Piece& piece : face)
  {
    this->FaceOf[piece.cell] = this->size();
  }
  this->Faces.push_back(std::move(face));
}

int FlatFaceCells::faceOf(int cell) const
{
  const auto found = this->FaceOf.find(cell);
  return found == this->FaceOf.end() ? -1 : found->second;
}

void FlatFaceCells::write(const std::set<int>& cells, vtkFieldData* data) const
{
  std::set<int> faces;
  for (const int cell : cells)
  {
    faces.insert(this->faceOf(cell));
  }
  faces.erase(-1);
  if (faces.empty())
  {
    return;
  }
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetName("FlatFaceOffsets");
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("FlatFaceCells");
  vtkNew<vtkDoubleArray> corners;
  corners->SetName("FlatFaceCorners");
  corners->SetNumberOfComponents(9);
  for (const int face : faces)
  {
    offsets->InsertNextValue(ids->GetNumberOfTuples());
    for (const Piece& piece : this->Faces[face])
    {
      ids->InsertNextValue(piece.cell);
      const auto& [a, b, c] = piece.corners;
      corners->InsertNextTuple9(a.x(), a.y(), a.z(), b.x(), b.y(), b.z(), c.x(), c.y(), c.z());
    }
  }
  offsets->InsertNextValue(ids->GetNumberOfTuples());
  data->AddArray(offsets);
  data->AddArray(ids);
  data->AddArray(corners);
}

Status FlatFaceCells::read(vtkFieldData* data, const std::string& owner)
{
  vtkDataArray* offsets = data->GetArray("FlatFaceOffsets");
  if (!offsets)
  {
    return Status::success();
  }
  const std::string remedy = "pass output port 0 of vtkConformalAtlas";
  const vtkIdType faces = offsets->GetNumberOfTuples() - 1;
  int total = 0;
  if (faces >= 0)
  {
    total = indexBelow(offsets->GetComponent(faces, 0), MaximumNumberOfElements);
  }
  vtkDataArray* ids = nullptr;
  vtkDataArray* corners = nullptr;
  for (const Status& status : { findArray(data, "FlatFaceCells", 1, total, owner, remedy, ids),
         findArray(data, "FlatFaceCorners", 9, total, owner, remedy, corners) })
  {
    if (!status.ok())
    {
      return status;
    }
  }
  vtkIdType i = 0;
  for (vtkIdType f = 0; f < faces; ++f)
  {
    const int end = indexBelow(offsets->GetComponent(f + 1, 0), total + 1);
    if (end < i)
    {
      return badId(offsets, f + 1, "flat face " + std::to_string(f + 1), total + 1);
    }
    std::vector<Piece> pieces;
    bool isKnown = false;
    for (; i < end; ++i)
    {
      Piece piece;
      piece.cell = indexBelow(ids->GetComponent(i, 0), VTK_INT_MAX);
      if (piece.cell < 0)
      {
        return badId(ids, i, "flat face " + std::to_string(f), VTK_INT_MAX);
      }
      isKnown = isKnown || this->faceOf(piece.cell) >= 0;
      for (int k = 0; k < 9; ++k)
      {
        piece.corners[k / 3][k % 3] = corners->GetComponent(i, k);
      }
      pieces.push_back(piece);
    }
    if (!isKnown && !pieces.empty())
    {
      this->add(std::move(pieces));
    }
  }
  return Status::success();
}

int FlatFaceLocator::cellAt(int cell, const Vec3& place)
{
  const int face = this->Faces.faceOf(cell);
  if (face < 0)
  {
    return cell;
  }
  const std::vector<FlatFaceCells::Piece>& pieces = this->Faces.pieces(face);
  std::unique_ptr<CellLocator>& locator = this->Locators[face];
  if (!locator)
  {
    std::vector<Vec3> points;
    std::vector<Triangle> triangles;
    for (const FlatFaceCells::Piece& piece : pieces)
    {
      const int first = static_cast<int>(points.size());
      points.insert(points.end(), piece.corners.begin(), piece.corners.end());
      triangles.push_back({ first, first + 1, first + 2 });
    }
    locator = std::make_unique<CellLocator>(points, triangles);
  }
  const vtkIdType piece = locator->nearest(place).cell;
  return piece < 0 ? cell : pieces[static_cast<std::size_t>(piece)].cell;
}
}
