// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SelectedPart.h"

#include "AtlasConstants.h"
#include "CoincidentPoints.h"
#include "CornerTexture.h"
#include "PolyDataConversion.h"
#include "SurfaceRepair.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTriangleStrip.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace stipple
{
namespace
{
using Edge = std::pair<vtkIdType, vtkIdType>;

/// Calls visit(from, to) for the edges of a polygon.
template <typename Visit>
void forEachEdge(vtkCellArray* polygons, vtkIdType polygon, const Visit& visit)
{
  vtkIdType size;
  const vtkIdType* ids;
  polygons->GetCellAtId(polygon, size, ids);
  for (vtkIdType k = 0; k < size; ++k)
  {
    visit(ids[k], ids[(k + 1) % size]);
  }
}

/// Makes one of points that are apart by rounding alone, where a surface is closed between them and
/// one of them is the part's: what the atlas welds must be one point for the rest, too.
Status weldAsAtlas(
  vtkPolyData* input, const std::vector<char>& isOfPart, std::vector<vtkIdType>& firstAt)
{
  RepairedSurface repaired;
  if (Status status = repairSurface(input, repaired); !status.ok())
  {
    return status;
  }
  const auto n = static_cast<vtkIdType>(firstAt.size());
  const double most = AtlasConstants::SamePlace * input->GetLength();
  std::vector<vtkIdType> welded = firstAt;
  std::vector<char> hasPart(firstAt.size(), 0);
  for (vtkIdType p = 0; p < n; ++p)
  {
    const int vertex = repaired.pointOfInput[p];
    const vtkIdType source = vertex < 0 ? p : repaired.sourcePoint[vertex];
    const Vec3 apart = Vec3(input->GetPoint(source)) - Vec3(input->GetPoint(p));
    welded[p] = firstAt[apart.norm() <= most ? source : p];
    hasPart[welded[p]] = hasPart[welded[p]] || isOfPart[p];
  }
  for (vtkIdType p = 0; p < n; ++p)
  {
    firstAt[p] = hasPart[welded[p]] ? welded[p] : firstAt[p];
  }
  return Status::success();
}

/// Swaps the edges inside a mesh of triangles that the rest has, too, between the same points of
/// the border: four triangles would share them. False if one cannot be swapped.
bool swapEdgesOfRest(const std::set<Edge>& edgesOfRest, const std::vector<Vec3>& points,
  std::vector<Triangle>& triangles)
{
  std::map<Edge, std::vector<int>> faces;
  for (std::size_t f = 0; f < triangles.size(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      faces[Edge(std::minmax(triangles[f][k], triangles[f][(k + 1) % 3]))].push_back(
        static_cast<int>(f));
    }
  }
  const auto normal = [&](const Triangle& t) {
    return Vec3((points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]));
  };
  std::vector<Edge> doubled;
  for (const auto& [edge, both] : faces)
  {
    if (both.size() == 2 && edgesOfRest.count(edge) > 0)
    {
      doubled.push_back(edge);
    }
  }
  for (const Edge& edge : doubled)
  {
    const std::vector<int> both = faces[edge];
    Triangle& own = triangles[both[0]];
    Triangle& other = triangles[both[1]];
    const int a = static_cast<int>(edge.first);
    const int b = static_cast<int>(edge.second);
    const int c = own[0] + own[1] + own[2] - a - b;
    const int d = other[0] + other[1] + other[2] - a - b;
    const Edge swapped(std::minmax(c, d));
    Triangle first = own; // b is replaced by d, and a by c in the other
    Triangle second = other;
    std::replace(first.begin(), first.end(), b, d);
    std::replace(second.begin(), second.end(), a, c);
    const Vec3 before = normal(own) + normal(other);
    if (faces.count(swapped) > 0 || edgesOfRest.count(swapped) > 0 ||
      !(normal(first).dot(before) > 0) || !(normal(second).dot(before) > 0))
    {
      return false;
    }
    own = first;
    other = second;
    faces.erase(edge);
    faces[swapped] = both;
    const Edge besideOwn(std::minmax(b, c));
    const Edge besideOther(std::minmax(a, d));
    std::replace(faces[besideOwn].begin(), faces[besideOwn].end(), both[0], both[1]);
    std::replace(faces[besideOther].begin(), faces[besideOther].end(), both[1], both[0]);
  }
  return true;
}

/// Arrays like the mesh's: with the rest's tuples from the input's array of that name, where there
/// is one alike, then the mesh's.
void joinArrays(vtkDataSetAttributes* input, const std::vector<vtkIdType>& rest,
  vtkDataSetAttributes* mesh, const std::vector<vtkIdType>& fromMesh, vtkDataSetAttributes* result)
{
  const auto restSize = static_cast<vtkIdType>(rest.size());
  for (int a = 0; a < mesh->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* own = mesh->GetAbstractArray(a);
    auto joined = vtkSmartPointer<vtkAbstractArray>::Take(own->NewInstance());
    joined->SetName(own->GetName());
    joined->SetNumberOfComponents(own->GetNumberOfComponents());
    joined->SetNumberOfTuples(restSize + static_cast<vtkIdType>(fromMesh.size()));
    vtkAbstractArray* given = own->GetName() ? input->GetAbstractArray(own->GetName()) : nullptr;
    const bool isAlike = given && given->GetDataType() == own->GetDataType() &&
      given->GetNumberOfComponents() == own->GetNumberOfComponents();
    auto* numbers = vtkDataArray::SafeDownCast(joined);
    const bool isInteger = own->GetDataType() != VTK_FLOAT && own->GetDataType() != VTK_DOUBLE;
    for (vtkIdType i = 0; i < restSize; ++i)
    {
      if (isAlike)
      {
        joined->SetTuple(i, rest[i], given);
      }
      else if (numbers)
      {
        for (int k = 0; k < numbers->GetNumberOfComponents(); ++k)
        {
          numbers->SetComponent(i, k, isInteger ? -1. : 0.);
        }
      }
    }
    for (std::size_t i = 0; i < fromMesh.size(); ++i)
    {
      joined->SetTuple(restSize + static_cast<vtkIdType>(i), fromMesh[i], own);
    }
    result->AddArray(joined);
  }
  for (int attribute = 0; attribute < vtkDataSetAttributes::NUM_ATTRIBUTES; ++attribute)
  {
    if (vtkAbstractArray* active = mesh->GetAbstractAttribute(attribute);
        active && active->GetName())
    {
      result->SetActiveAttribute(active->GetName(), attribute);
    }
  }
}
}

Status SelectedPart::split(vtkPolyData* input, const std::string& array)
{
  vtkDataArray* labels = input->GetCellData()->GetArray(array.c_str());
  if (!labels || labels->GetNumberOfComponents() != 1)
  {
    return Status::error(
      "The input has no cell array '" + array + "' of one number a cell to select by.");
  }
  *this = SelectedPart();
  this->Input = vtkSmartPointer<vtkPolyData>::New();
  this->Input->SetPoints(input->GetPoints());
  this->Input->GetPointData()->ShallowCopy(input->GetPointData());
  vtkNew<vtkCellArray> polygons;
  const vtkIdType firstPolygon = input->GetNumberOfVerts() + input->GetNumberOfLines();
  const vtkIdType firstStrip = firstPolygon + input->GetNumberOfPolys();
  vtkIdType size;
  const vtkIdType* ids;
  for (vtkIdType cell = firstPolygon; cell < firstPolygon + input->GetNumberOfPolys(); ++cell)
  {
    input->GetPolys()->GetCellAtId(cell - firstPolygon, size, ids);
    polygons->InsertNextCell(size, ids);
    this->SourceCell.push_back(cell);
  }
  for (vtkIdType strip = 0; strip < input->GetNumberOfStrips(); ++strip)
  {
    input->GetStrips()->GetCellAtId(strip, size, ids);
    vtkTriangleStrip::DecomposeStrip(static_cast<int>(size), ids, polygons);
    this->SourceCell.resize(polygons->GetNumberOfCells(), firstStrip + strip);
  }
  this->Input->SetPolys(polygons);

  this->FirstAt = firstAtPlace(input);
  std::vector<char> isOfPart(this->FirstAt.size(), 0);
  const auto isSelected = [&](vtkIdType f) {
    return labels->GetComponent(this->SourceCell[f], 0) != 0.;
  };
  for (vtkIdType f = 0; f < polygons->GetNumberOfCells(); ++f)
  {
    if (isSelected(f))
    {
      forEachEdge(polygons, f, [&](vtkIdType a, vtkIdType) { isOfPart[a] = 1; });
    }
  }
  const std::vector<vtkIdType> atPlace = this->FirstAt;
  if (Status status = weldAsAtlas(this->Input, isOfPart, this->FirstAt); !status.ok())
  {
    return status;
  }
  const auto isWelded = [&](vtkIdType p) { return this->FirstAt[p] != atPlace[p]; };
  vtkNew<vtkCellArray> selected;
  std::set<Edge> edgesOfRest;
  const auto edgeOf = [this](vtkIdType a, vtkIdType b) {
    return Edge(std::minmax(this->FirstAt[a], this->FirstAt[b]));
  };
  std::vector<vtkIdType> corners;
  for (vtkIdType f = 0; f < polygons->GetNumberOfCells(); ++f)
  {
    corners.clear();
    forEachEdge(polygons, f, [&](vtkIdType a, vtkIdType b) {
      if (this->FirstAt[a] != this->FirstAt[b] || !(isWelded(a) || isWelded(b)))
      {
        corners.push_back(isWelded(a) ? this->FirstAt[a] : a);
      }
    });
    if (corners.size() < 3) // between points that are one
    {
      continue;
    }
    if (isSelected(f))
    {
      this->PartCells.push_back(f);
      selected->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
    }
    else
    {
      this->RestCells.push_back(f);
      forEachEdge(polygons, f, [&](vtkIdType a, vtkIdType b) { edgesOfRest.insert(edgeOf(a, b)); });
    }
  }
  if (this->PartCells.empty())
  {
    return Status::error("All values of '" + array + "' are 0: no cell is selected.");
  }
  this->Part = vtkSmartPointer<vtkPolyData>::New();
  this->Part->SetPoints(input->GetPoints());
  this->Part->SetPolys(selected);
  this->Part->GetPointData()->ShallowCopy(input->GetPointData());
  this->Part->GetCellData()->CopyAllocate(input->GetCellData());
  for (std::size_t i = 0; i < this->PartCells.size(); ++i)
  {
    this->Part->GetCellData()->CopyData(
      input->GetCellData(), this->SourceCell[this->PartCells[i]], static_cast<vtkIdType>(i));
  }
  this->Input->GetCellData()->ShallowCopy(input->GetCellData());
  this->BorderEdges = vtkSmartPointer<vtkIdTypeArray>::New();
  this->BorderEdges->SetNumberOfComponents(2);
  std::set<vtkIdType> ends;
  for (vtkIdType f = 0; f < selected->GetNumberOfCells(); ++f)
  {
    forEachEdge(selected, f, [&](vtkIdType a, vtkIdType b) {
      if (edgesOfRest.count(edgeOf(a, b)) > 0)
      {
        this->BorderEdges->InsertNextValue(a);
        this->BorderEdges->InsertNextValue(b);
        ends.insert({ this->FirstAt[a], this->FirstAt[b] });
      }
    });
  }
  this->BorderPoints.assign(ends.begin(), ends.end());
  return Status::success();
}

void SelectedPart::joinTexture(
  vtkPolyData* mesh, const std::vector<vtkIdType>& idOfMeshPoint, vtkPolyData* result) const
{
  vtkDataArray* ofMesh = cornerTexture(mesh);
  vtkDataArray* ofPoints = this->Input->GetPointData()->GetTCoords();
  vtkCellArray* polygons = result->GetPolys();
  auto joined = newCornerTexture(polygons->GetNumberOfCells(), polygons->GetMaxCellSize());
  vtkIdType size;
  const vtkIdType* ids;
  vtkIdType cell = 0;
  for (const vtkIdType f : this->RestCells)
  {
    this->Input->GetPolys()->GetCellAtId(f, size, ids);
    for (vtkIdType k = 0; k < size; ++k)
    {
      setTextureOfCorner(joined, cell, k, textureOfCorner(ofPoints, ids[k], 0));
    }
    ++cell;
  }
  // By the cell's own corners, and in cells whose edge was swapped by those that their points had.
  std::map<vtkIdType, Vec2> another;
  std::vector<std::pair<vtkIdType, vtkIdType>> missing; // a cell and its corner
  for (vtkIdType t = 0; t < mesh->GetNumberOfPolys(); ++t, ++cell)
  {
    const vtkIdType* now;
    mesh->GetPolys()->GetCellAtId(t, size, ids);
    polygons->GetCellAtId(cell, size, now);
    for (vtkIdType k = 0; k < size; ++k)
    {
      const vtkIdType* before =
        std::find_if(ids, ids + size, [&](vtkIdType p) { return idOfMeshPoint[p] == now[k]; });
      if (before != ids + size)
      {
        setTextureOfCorner(joined, cell, k, textureOfCorner(ofMesh, t, before - ids));
      }
      else
      {
        missing.emplace_back(cell, k);
      }
      another.try_emplace(idOfMeshPoint[ids[k]], textureOfCorner(ofMesh, t, k));
    }
  }
  for (const auto& [lacking, k] : missing)
  {
    polygons->GetCellAtId(lacking, size, ids);
    setTextureOfCorner(joined, lacking, k, another.at(ids[k]));
  }
  result->GetCellData()->AddArray(joined);
}

Status SelectedPart::join(vtkPolyData* mesh, vtkPolyData* lines, vtkPolyData* result) const
{
  // The rest's points, then the mesh's that are none of them.
  std::set<vtkIdType> used;
  for (const vtkIdType f : this->RestCells)
  {
    forEachEdge(
      this->Input->GetPolys(), f, [&](vtkIdType a, vtkIdType) { used.insert(this->FirstAt[a]); });
  }
  const std::vector<vtkIdType> rest(used.begin(), used.end());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  std::map<vtkIdType, vtkIdType> newId;
  for (const vtkIdType p : rest)
  {
    newId[p] = points->InsertNextPoint(this->Input->GetPoint(p));
  }
  std::map<Place, vtkIdType> border;
  for (const vtkIdType p : this->BorderPoints)
  {
    border[placeOf(this->Input->GetPoint(p))] = newId[p];
  }
  std::vector<vtkIdType> idOfMeshPoint;
  std::vector<vtkIdType> fromMesh;
  std::set<vtkIdType> met;
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    const auto found = border.find(placeOf(mesh->GetPoint(p)));
    if (found != border.end())
    {
      idOfMeshPoint.push_back(found->second);
      met.insert(found->second);
    }
    else
    {
      idOfMeshPoint.push_back(points->InsertNextPoint(mesh->GetPoint(p)));
      fromMesh.push_back(p);
    }
  }
  if (met.size() != border.size())
  {
    return Status::internal("The mesh of the selected part lacks " +
      std::to_string(border.size() - met.size()) + " of the " + std::to_string(border.size()) +
      " points on its border.");
  }
  vtkNew<vtkCellArray> polygons;
  std::set<Edge> edgesOfRest;
  for (const vtkIdType f : this->RestCells)
  {
    polygons->InsertNextCell(static_cast<int>(this->Input->GetPolys()->GetCellSize(f)));
    forEachEdge(this->Input->GetPolys(), f, [&](vtkIdType a, vtkIdType b) {
      const vtkIdType p = newId.at(this->FirstAt[a]);
      polygons->InsertCellPoint(p);
      edgesOfRest.insert(std::minmax({ p, newId.at(this->FirstAt[b]) }));
    });
  }
  TriangleSurface joined = fromPolyData(mesh);
  for (Triangle& t : joined.triangles)
  {
    std::transform(
      t.begin(), t.end(), t.begin(), [&](int p) { return static_cast<int>(idOfMeshPoint[p]); });
  }
  joined.points.resize(static_cast<std::size_t>(points->GetNumberOfPoints()));
  for (std::size_t p = 0; p < joined.points.size(); ++p)
  {
    points->GetPoint(static_cast<vtkIdType>(p), joined.points[p].data());
  }
  if (!swapEdgesOfRest(edgesOfRest, joined.points, joined.triangles))
  {
    return Status::tooFewPoints("The mesh of the selected part is too coarse for its border, and "
                                "would fold over the rest; use "
                                "more points.");
  }
  for (const Triangle& t : joined.triangles)
  {
    polygons->InsertNextCell({ t[0], t[1], t[2] });
  }
  result->Initialize();
  result->SetPoints(points);
  result->SetPolys(polygons);

  result->GetFieldData()->ShallowCopy(mesh->GetFieldData());
  joinArrays(
    this->Input->GetPointData(), rest, mesh->GetPointData(), fromMesh, result->GetPointData());
  std::vector<vtkIdType> sourceOfRest;
  std::transform(this->RestCells.begin(), this->RestCells.end(), std::back_inserter(sourceOfRest),
    [this](vtkIdType f) { return this->SourceCell[f]; });
  std::vector<vtkIdType> allOfMesh(static_cast<std::size_t>(mesh->GetNumberOfPolys()));
  std::iota(allOfMesh.begin(), allOfMesh.end(), 0);
  joinArrays(this->Input->GetCellData(), sourceOfRest, mesh->GetCellData(), allOfMesh,
    result->GetCellData());
  if (cornerTexture(mesh))
  {
    this->joinTexture(mesh, idOfMeshPoint, result);
  }
  if (vtkDataArray* source = result->GetPointData()->GetArray("SourceCellId"))
  {
    for (auto p = static_cast<vtkIdType>(rest.size()); p < source->GetNumberOfTuples(); ++p)
    {
      const auto cell = static_cast<std::size_t>(source->GetComponent(p, 0));
      source->SetComponent(p, 0, static_cast<double>(this->SourceCell[this->PartCells[cell]]));
    }
  }

  vtkNew<vtkCellArray> polylines;
  for (vtkIdType l = 0; l < lines->GetNumberOfLines(); ++l)
  {
    vtkIdType size;
    const vtkIdType* ids;
    lines->GetLines()->GetCellAtId(l, size, ids);
    polylines->InsertNextCell(static_cast<int>(size));
    std::for_each(
      ids, ids + size, [&](vtkIdType p) { polylines->InsertCellPoint(idOfMeshPoint[p]); });
  }
  lines->SetPoints(points);
  lines->SetLines(polylines);
  return Status::success();
}
}
