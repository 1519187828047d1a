// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PlyFile.h"

#include "CornerTexture.h"
#include "RegionFile.h"
#include "Text.h"
#include "TextNumbers.h"
#include "UserArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>
#include <string_view>
#include <vector>

namespace stipple
{
namespace
{
constexpr vtkIdType MostTextureNumbers = 254; ///< of a face: pairs that a byte can count

enum class Type
{
  None,
  Int8,
  UInt8,
  Int16,
  UInt16,
  Int32,
  UInt32,
  Float32,
  Float64
};

Type typeOf(const std::string& name)
{
  static const std::map<std::string, Type> types = { { "char", Type::Int8 }, { "int8", Type::Int8 },
    { "uchar", Type::UInt8 }, { "uint8", Type::UInt8 }, { "short", Type::Int16 },
    { "int16", Type::Int16 }, { "ushort", Type::UInt16 }, { "uint16", Type::UInt16 },
    { "int", Type::Int32 }, { "int32", Type::Int32 }, { "uint", Type::UInt32 },
    { "uint32", Type::UInt32 }, { "float", Type::Float32 }, { "float32", Type::Float32 },
    { "double", Type::Float64 }, { "float64", Type::Float64 } };
  const auto found = types.find(name);
  return found == types.end() ? Type::None : found->second;
}

struct Property
{
  std::string name;
  Type type = Type::None;
  Type countType = Type::None; ///< of a list
  bool isList() const { return this->countType != Type::None; }
};

struct Element
{
  std::string name;
  long long count = 0;
  std::vector<Property> properties;
};

bool littleEndian()
{
  const std::uint16_t one = 1;
  unsigned char first;
  std::memcpy(&first, &one, 1);
  return first == 1;
}

class PlyReader
{
public:
  PlyReader(std::string file, std::string text)
    : File(std::move(file))
    , Text(std::move(text))
  {
  }

  Status read(vtkPolyData* mesh)
  {
    Status status = this->readHeader();
    bool hasVertices = false;
    for (const Element& element : this->Elements)
    {
      if (status.ok() && element.count > static_cast<long long>(this->Text.size()))
      {
        status = this->error(
          "it is too short for " + std::to_string(element.count) + " of its " + element.name);
      }
      if (status.ok() && element.name == "vertex")
      {
        status = this->readVertices(element, mesh);
        hasVertices = true;
      }
      else if (status.ok() && element.name == "face")
      {
        status = this->readFaces(element, mesh);
      }
      else if (status.ok())
      {
        status = this->skip(element);
      }
    }
    return status.ok() && !hasVertices ? this->error("it has no vertices") : status;
  }

private:
  Status error(const std::string& sentence) const
  {
    return Status::error("cannot read '" + this->File + "': " + sentence);
  }
  Status endsEarly(const Element& element, long long item) const
  {
    return this->error("it ends, or is no number, at " + element.name + " " + std::to_string(item) +
      " of " + std::to_string(element.count));
  }

  std::string headerLine()
  {
    const std::size_t end = std::min(this->Text.find('\n', this->Next), this->Text.size());
    std::string line = this->Text.substr(this->Next, end - this->Next);
    this->Next = std::min(end + 1, this->Text.size());
    if (!line.empty() && line.back() == '\r')
    {
      line.pop_back();
    }
    return line;
  }

  Status readHeader()
  {
    if (this->headerLine() != "ply")
    {
      return this->error("it is no PLY file");
    }
    bool hasFormat = false;
    while (this->Next < this->Text.size())
    {
      std::istringstream words(this->headerLine());
      std::string key;
      std::string first;
      words >> key;
      if (key == "end_header")
      {
        return hasFormat ? Status::success() : this->error("its header names no format");
      }
      words >> first;
      if (key == "format")
      {
        hasFormat =
          first == "ascii" || first == "binary_little_endian" || first == "binary_big_endian";
        this->Ascii = first == "ascii";
        this->Swap = (first == "binary_little_endian") != littleEndian();
      }
      else if (key == "element")
      {
        Element element;
        element.name = first;
        if (!(words >> element.count) || element.count < 0)
        {
          return this->error("its header does not say how many of " + first + " there are");
        }
        this->Elements.push_back(element);
      }
      else if (key == "property" && !this->Elements.empty())
      {
        Property property;
        if (first == "list")
        {
          std::string count;
          words >> count >> first;
          property.countType = typeOf(count);
        }
        property.type = typeOf(first);
        words >> property.name;
        if (property.type == Type::None || property.name.empty())
        {
          return this->error("its header has a property of unknown type '" + first + "'");
        }
        this->Elements.back().properties.push_back(property);
      }
    }
    return this->error("its header does not end");
  }

  template <typename T>
  bool binary(double& value)
  {
    if (this->Text.size() - this->Next < sizeof(T))
    {
      return false;
    }
    char bytes[sizeof(T)];
    std::memcpy(bytes, this->Text.data() + this->Next, sizeof(T));
    this->Next += sizeof(T);
    if (this->Swap)
    {
      std::reverse(bytes, bytes + sizeof(T));
    }
    T number;
    std::memcpy(&number, bytes, sizeof(T));
    value = static_cast<double>(number);
    return true;
  }

  bool number(Type type, double& value)
  {
    if (this->Ascii)
    {
      const std::size_t begin =
        std::min(this->Text.find_first_not_of(" \t\r\n", this->Next), this->Text.size());
      this->Next = std::min(this->Text.find_first_of(" \t\r\n", begin), this->Text.size());
      return parseAnyNumber(std::string_view(this->Text).substr(begin, this->Next - begin), value);
    }
    switch (type)
    {
      case Type::Int8:
        return this->binary<std::int8_t>(value);
      case Type::UInt8:
        return this->binary<std::uint8_t>(value);
      case Type::Int16:
        return this->binary<std::int16_t>(value);
      case Type::UInt16:
        return this->binary<std::uint16_t>(value);
      case Type::Int32:
        return this->binary<std::int32_t>(value);
      case Type::UInt32:
        return this->binary<std::uint32_t>(value);
      case Type::Float32:
        return this->binary<float>(value);
      case Type::Float64:
        return this->binary<double>(value);
      default:
        return false;
    }
  }

  bool list(const Property& property, std::vector<double>& values)
  {
    double size = 0;
    values.clear();
    if (!this->number(property.countType, size) || !(size >= 0) ||
      size > static_cast<double>(this->Text.size() - this->Next))
    {
      return false;
    }
    values.resize(static_cast<std::size_t>(size));
    return std::all_of(values.begin(), values.end(),
      [&](double& value) { return this->number(property.type, value); });
  }

  Status skip(const Element& element)
  {
    double value;
    std::vector<double> values;
    for (long long i = 0; i < element.count; ++i)
    {
      for (const Property& property : element.properties)
      {
        if (!(property.isList() ? this->list(property, values)
                                : this->number(property.type, value)))
        {
          return this->endsEarly(element, i);
        }
      }
    }
    return Status::success();
  }

  /// One array a property that is a number; null for lists and for the names in `without`.
  static std::vector<vtkSmartPointer<vtkDoubleArray>> makeArrays(
    const Element& element, const std::vector<std::string>& without)
  {
    std::vector<vtkSmartPointer<vtkDoubleArray>> arrays(element.properties.size());
    for (std::size_t k = 0; k < arrays.size(); ++k)
    {
      const Property& property = element.properties[k];
      if (!property.isList() &&
        std::find(without.begin(), without.end(), property.name) == without.end())
      {
        arrays[k] = vtkSmartPointer<vtkDoubleArray>::New();
        arrays[k]->SetName(property.name.c_str());
        arrays[k]->SetNumberOfValues(element.count);
      }
    }
    return arrays;
  }

  Status readVertices(const Element& element, vtkPolyData* mesh)
  {
    const std::vector<std::string> axes = { "x", "y", "z" };
    std::vector<int> axisOf;
    for (const Property& property : element.properties)
    {
      const auto axis = std::find(axes.begin(), axes.end(), property.name);
      axisOf.push_back(
        axis == axes.end() || property.isList() ? -1 : static_cast<int>(axis - axes.begin()));
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      if (std::count(axisOf.begin(), axisOf.end(), axis) != 1)
      {
        return this->error("its vertices have no " + axes[axis]);
      }
    }
    const auto arrays = makeArrays(element, axes);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(element.count);
    std::vector<double> values;
    for (long long i = 0; i < element.count; ++i)
    {
      double x[3];
      for (std::size_t k = 0; k < axisOf.size(); ++k)
      {
        const Property& property = element.properties[k];
        double value = 0;
        if (!(property.isList() ? this->list(property, values)
                                : this->number(property.type, value)))
        {
          return this->endsEarly(element, i);
        }
        if (axisOf[k] >= 0)
        {
          x[axisOf[k]] = value;
        }
        else if (arrays[k])
        {
          arrays[k]->SetValue(i, value);
        }
      }
      points->SetPoint(i, x);
    }
    mesh->SetPoints(points);
    for (const auto& array : arrays)
    {
      if (array)
      {
        mesh->GetPointData()->AddArray(array);
      }
    }
    addTexture(mesh->GetPointData());
    return Status::success();
  }

  /// The first pair of arrays that has a name for texture coordinates, as such.
  static void addTexture(vtkPointData* data)
  {
    for (const auto& [first, second] : { std::pair("s", "t"), std::pair("u", "v"),
           std::pair("texture_s", "texture_t"), std::pair("texture_u", "texture_v") })
    {
      vtkDataArray* u = data->GetArray(first);
      vtkDataArray* v = data->GetArray(second);
      if (u && v)
      {
        vtkNew<vtkDoubleArray> texture;
        texture->SetName("TextureCoordinates");
        texture->SetNumberOfComponents(2);
        texture->SetNumberOfTuples(u->GetNumberOfTuples());
        texture->CopyComponent(0, u, 0);
        texture->CopyComponent(1, v, 0);
        data->SetTCoords(texture);
        return;
      }
    }
  }

  Status readFaces(const Element& element, vtkPolyData* mesh)
  {
    const auto arrays = makeArrays(element, {});
    vtkNew<vtkCellArray> verts;
    vtkNew<vtkCellArray> lines;
    vtkNew<vtkCellArray> polys;
    std::vector<double> values;
    std::vector<vtkIdType> ids;
    std::vector<std::vector<double>> texture; // by face
    for (long long i = 0; i < element.count; ++i)
    {
      for (std::size_t k = 0; k < element.properties.size(); ++k)
      {
        const Property& property = element.properties[k];
        double value = 0;
        if (!(property.isList() ? this->list(property, values)
                                : this->number(property.type, value)))
        {
          return this->endsEarly(element, i);
        }
        if (arrays[k])
        {
          arrays[k]->SetValue(i, value);
        }
        else if (property.name == "vertex_indices" || property.name == "vertex_index")
        {
          ids.resize(values.size());
          for (std::size_t j = 0; j < ids.size(); ++j)
          {
            // What is no id of a point is found with those out of range.
            ids[j] = std::abs(values[j]) < 1e15 && std::floor(values[j]) == values[j]
              ? static_cast<vtkIdType>(values[j])
              : -1;
          }
          if (!ids.empty())
          {
            vtkCellArray* cells = ids.size() == 1 ? verts : (ids.size() == 2 ? lines : polys);
            cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
          }
        }
        else if (property.name == "texcoord")
        {
          texture.resize(static_cast<std::size_t>(i));
          texture.push_back(values);
        }
      }
    }
    mesh->SetVerts(verts);
    mesh->SetLines(lines);
    mesh->SetPolys(polys);
    for (const auto& array : arrays)
    {
      if (array && polys->GetNumberOfCells() == element.count) // else cells have another order than
                                                               // faces
      {
        mesh->GetCellData()->AddArray(array);
      }
    }
    if (!texture.empty() && polys->GetNumberOfCells() == element.count)
    {
      // Points with several pairs become several, as VTK draws them.
      mesh->GetCellData()->AddArray(cornersOf(texture, polys));
      if (checkCells(polys, mesh->GetNumberOfPoints(), "").ok()) // else the reader is told later
      {
        mesh->ShallowCopy(splitTextureSeams(mesh));
      }
    }
    return Status::success();
  }

  /// What a face has too little of is 0.
  static vtkSmartPointer<vtkDoubleArray> cornersOf(
    const std::vector<std::vector<double>>& texture, vtkCellArray* polygons)
  {
    auto corners = newCornerTexture(polygons->GetNumberOfCells(), polygons->GetMaxCellSize());
    for (std::size_t f = 0; f < texture.size(); ++f)
    {
      const auto face = static_cast<vtkIdType>(f);
      const auto size = static_cast<std::size_t>(2 * polygons->GetCellSize(face));
      for (std::size_t k = 0; k < std::min(size, texture[f].size()); ++k)
      {
        corners->SetComponent(face, static_cast<int>(k), texture[f][k]);
      }
    }
    return corners;
  }

  std::string File;
  std::string Text;
  std::size_t Next = 0;
  bool Ascii = false;
  bool Swap = false;
  std::vector<Element> Elements;
};

/// The labels of a mesh's regions, as a property of faces: numbers as they are, words counted.
class FaceLabels
{
public:
  explicit FaceLabels(vtkPolyData* mesh)
    : Regions(mesh)
  {
    vtkDataArray* numbers = mesh->GetCellData()->GetArray(this->Regions.array().c_str());
    for (std::size_t r = 0; r < this->Regions.names().size(); ++r)
    {
      const std::vector<int>& cells = this->Regions.cells()[r];
      const double label =
        numbers ? numbers->GetComponent(cells.front(), 0) : static_cast<double>(r);
      this->Labels.resize(static_cast<std::size_t>(mesh->GetNumberOfPolys()));
      std::for_each(cells.begin(), cells.end(), [&](int cell) { this->Labels[cell] = label; });
      this->AreInts = this->AreInts &&
        std::abs(label) <= std::numeric_limits<std::int32_t>::max() && label == std::floor(label);
    }
  }
  std::string header() const
  {
    std::string name = this->Regions.array();
    std::replace(name.begin(), name.end(), ' ', '_');
    return this->Labels.empty()
      ? std::string()
      : (this->AreInts ? "property int " : "property double ") + name + '\n';
  }
  void write(std::ostream& stream, vtkIdType face) const
  {
    if (!this->Labels.empty())
    {
      const double number = this->Labels[face];
      const auto integer = static_cast<std::int32_t>(this->AreInts ? number : 0.);
      stream.write(this->AreInts ? reinterpret_cast<const char*>(&integer)
                                 : reinterpret_cast<const char*>(&number),
        this->AreInts ? sizeof(integer) : sizeof(number));
    }
  }

private:
  MeshRegions Regions;
  std::vector<double> Labels; // by face
  bool AreInts = true;
};
}

Status readPly(const std::string& file, vtkPolyData* mesh)
{
  return PlyReader(file, contentOf(file)).read(mesh);
}

bool writePly(vtkPolyData* mesh, const std::string& file)
{
  std::ofstream stream(file, std::ios::binary);
  const FaceLabels labels(mesh);
  stream << "ply\nformat binary_" << (littleEndian() ? "little" : "big")
         << "_endian 1.0\ncomment Stipple\nelement vertex " << mesh->GetNumberOfPoints()
         << "\nproperty double x\nproperty double y\nproperty double z\nelement face "
         << mesh->GetNumberOfPolys() << "\nproperty list uchar int vertex_indices\n";
  vtkDataArray* texture = cornerTexture(mesh);
  stream << labels.header() << (texture ? "property list uchar float texcoord\n" : "")
         << "end_header\n";
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    double x[3];
    mesh->GetPoint(p, x);
    stream.write(reinterpret_cast<const char*>(x), sizeof(x));
  }
  for (vtkIdType f = 0; f < mesh->GetNumberOfPolys(); ++f)
  {
    vtkIdType size;
    const vtkIdType* ids;
    mesh->GetPolys()->GetCellAtId(f, size, ids);
    stream.put(static_cast<char>(size));
    for (vtkIdType k = 0; k < size; ++k)
    {
      const auto id = static_cast<std::int32_t>(ids[k]);
      stream.write(reinterpret_cast<const char*>(&id), sizeof(id));
    }
    labels.write(stream, f);
    if (texture)
    {
      stream.put(static_cast<char>(std::min<vtkIdType>(2 * size, MostTextureNumbers)));
      for (int k = 0; k < std::min<vtkIdType>(2 * size, MostTextureNumbers); ++k)
      {
        const auto number = static_cast<float>(texture->GetComponent(f, k));
        stream.write(reinterpret_cast<const char*>(&number), sizeof(number));
      }
    }
  }
  stream.close();
  return static_cast<bool>(stream);
}
}
