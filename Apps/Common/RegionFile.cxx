// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RegionFile.h"

#include "Geometry.h"
#include "RegionArrays.h"
#include "Text.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkVariant.h"

#include <algorithm>
#include <limits>
#include <locale>
#include <map>
#include <sstream>
#include <string_view>

namespace stipple
{
namespace
{
const char* const Unnamed = "default";
const char* const MaterialIds = "MaterialIds";
const char* const LabelsOfSolids = "STLSolidLabeling"; // vtkSTLReader's

/// Names, each once, and which of them each face has.
class NamedRegions
{
public:
  void use(std::string_view name)
  {
    this->Name = name.empty() ? Unnamed : name;
    this->Known = false;
    this->HasNames = true;
  }
  void addFace()
  {
    if (!this->Known)
    {
      const auto [slot, fresh] =
        this->NumberOf.try_emplace(this->Name, static_cast<int>(this->Names.size()));
      if (fresh)
      {
        this->Names.push_back(this->Name);
      }
      this->Number = slot->second;
      this->Known = true;
    }
    this->Ids.push_back(this->Number);
  }
  bool hasNames() const { return this->HasNames; }
  const std::vector<std::string>& names() const { return this->Names; }
  const std::vector<int>& ids() const { return this->Ids; }

private:
  std::string Name = Unnamed;
  bool Known = false;
  bool HasNames = false;
  int Number = 0;
  std::map<std::string, int> NumberOf;
  std::vector<std::string> Names;
  std::vector<int> Ids;
};

/// Puts ids and names into a mesh, in place of arrays of that name.
void addRegions(const std::string& array, const std::vector<int>& ids,
  const std::vector<std::string>& names, vtkPolyData* mesh)
{
  vtkNew<vtkIntArray> cells;
  cells->SetName(array.c_str());
  cells->SetNumberOfValues(static_cast<vtkIdType>(ids.size()));
  std::copy(ids.begin(), ids.end(), cells->Begin());
  mesh->GetCellData()->AddArray(cells);
  vtkNew<vtkStringArray> texts;
  texts->SetName(regionNamesOf(array).c_str());
  for (const std::string& name : names)
  {
    texts->InsertNextValue(name);
  }
  mesh->GetFieldData()->AddArray(texts);
}
}

void addObjRegions(const std::string& content, vtkPolyData* mesh)
{
  std::istringstream stream(content);
  stream.exceptions(std::ios::badbit); // where memory ends, lines don't
  NamedRegions groups;
  NamedRegions objects;
  NamedRegions materials;
  for (std::string text; std::getline(stream, text);)
  {
    std::string_view rest = text;
    const std::string_view key = nextWord(rest);
    if (key == "g")
    {
      groups.use(trimmed(rest));
    }
    else if (key == "o")
    {
      objects.use(trimmed(rest));
    }
    else if (key == "usemtl")
    {
      materials.use(trimmed(rest));
    }
    else if (key == "f")
    {
      groups.addFace();
      objects.addFace();
      materials.addFace();
    }
  }
  const auto add = [mesh](const char* array, const NamedRegions& regions) {
    const vtkIdType others = mesh->GetNumberOfCells() - mesh->GetNumberOfPolys(); // they come first
    if (regions.hasNames() &&
      static_cast<vtkIdType>(regions.ids().size()) == mesh->GetNumberOfPolys())
    {
      std::vector<int> ids(static_cast<std::size_t>(others), 0);
      ids.insert(ids.end(), regions.ids().begin(), regions.ids().end());
      addRegions(array, ids, regions.names(), mesh);
    }
    else // vtkOBJReader's, which lines have none of
    {
      mesh->GetCellData()->RemoveArray(array);
    }
  };
  add("GroupIds", groups.hasNames() ? groups : objects);
  add(MaterialIds, materials);
}

void addStlSolids(const std::string& file, vtkPolyData* mesh)
{
  vtkDataArray* labels = mesh->GetCellData()->GetArray(LabelsOfSolids);
  if (!labels)
  {
    return;
  }
  std::vector<int> solid(static_cast<std::size_t>(labels->GetNumberOfTuples()));
  for (std::size_t i = 0; i < solid.size(); ++i)
  {
    solid[i] = static_cast<int>(labels->GetComponent(static_cast<vtkIdType>(i), 0));
  }
  mesh->GetCellData()->RemoveArray(LabelsOfSolids);
  const int number = solid.empty() ? 0 : *std::max_element(solid.begin(), solid.end()) + 1;
  if (number < 2)
  {
    return;
  }
  std::vector<std::string> names;
  std::ifstream stream(file, std::ios::binary);
  stream.exceptions(std::ios::badbit); // where memory ends, lines don't
  for (std::string text; std::getline(stream, text);)
  {
    std::string_view rest = text;
    if (nextWord(rest) == "solid")
    {
      const std::string_view name = trimmed(rest);
      names.push_back(name.empty() ? std::to_string(names.size()) : std::string(name));
    }
  }
  names.resize(static_cast<std::size_t>(number), Unnamed);
  addRegions("SolidIds", solid, names, mesh);
}

MeshRegions::MeshRegions(vtkPolyData* mesh)
  : Array(regionArrayName(mesh))
{
  vtkAbstractArray* labels =
    this->Array.empty() ? nullptr : mesh->GetCellData()->GetAbstractArray(this->Array.c_str());
  if (!labels)
  {
    return;
  }
  auto* names = vtkStringArray::SafeDownCast(
    mesh->GetFieldData()->GetAbstractArray(regionNamesOf(this->Array).c_str()));
  const std::vector<int> numbers = numberRegions(labels);
  for (std::size_t cell = 0; cell < numbers.size(); ++cell)
  {
    const auto number = static_cast<std::size_t>(numbers[cell]);
    this->Cells.resize(std::max(this->Cells.size(), number + 1));
    this->Cells[number].push_back(static_cast<int>(cell));
  }
  for (const std::vector<int>& cells : this->Cells)
  {
    const vtkVariant label = labels->GetVariantValue(cells.front());
    bool isId = false;
    const vtkIdType id = names ? label.ToTypeInt64(&isId) : -1;
    this->Names.push_back(isId && id >= 0 && id < names->GetNumberOfValues()
        ? std::string(names->GetValue(id))
        : label.ToString());
  }
}

std::string objRegionLine(const MeshRegions& regions, std::size_t number)
{
  return (regions.array() == MaterialIds ? "usemtl " : "g ") + regions.names()[number] + '\n';
}

std::string objMaterialLibrary(vtkPolyData* mesh, const MeshRegions& regions)
{
  auto* libraries = regions.array() == MaterialIds
    ? vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray("MaterialLibraries"))
    : nullptr;
  return libraries && libraries->GetNumberOfValues() > 0 ? std::string(libraries->GetValue(0))
                                                         : std::string();
}

bool writeStlSolids(vtkPolyData* mesh, const MeshRegions& regions, const std::string& file)
{
  std::ofstream stream(file, std::ios::binary);
  stream.imbue(std::locale::classic());
  stream.precision(std::numeric_limits<float>::max_digits10);
  const auto write = [&stream](const char* before, const Vec3& x) {
    const Eigen::Vector3f v = x.cast<float>();
    stream << before << ' ' << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
  };
  for (std::size_t r = 0; r < regions.names().size(); ++r)
  {
    stream << "solid " << regions.names()[r] << '\n';
    for (const int cell : regions.cells()[r])
    {
      vtkIdType size;
      const vtkIdType* ids;
      mesh->GetPolys()->GetCellAtId(cell, size, ids);
      for (vtkIdType k = 2; k < size; ++k)
      {
        std::array<Vec3, 3> x;
        mesh->GetPoint(ids[0], x[0].data());
        mesh->GetPoint(ids[k - 1], x[1].data());
        mesh->GetPoint(ids[k], x[2].data());
        write("facet normal", (x[1] - x[0]).cross(x[2] - x[0]).normalized());
        stream << "outer loop\n";
        for (const Vec3& p : x)
        {
          write("vertex", p);
        }
        stream << "endloop\nendfacet\n";
      }
    }
    stream << "endsolid " << regions.names()[r] << '\n';
  }
  stream.close();
  return static_cast<bool>(stream);
}
}
