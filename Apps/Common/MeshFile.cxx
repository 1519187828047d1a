// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFile.h"

#include "CornerTexture.h"
#include "FileCheck.h"
#include "Messages.h"
#include "ObjText.h"
#include "OffFile.h"
#include "PlyFile.h"
#include "RegionFile.h"
#include "Text.h"
#include "TextNumbers.h"
#include "XmlNames.h"

#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkGenericDataObjectReader.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataWriter.h"
#include "vtkSTLReader.h"
#include "vtkSTLWriter.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <new>
#include <utility>

#include <unistd.h>

namespace stipple
{
namespace
{
/// A file of a name of its own, gone with this.
class TemporaryFile
{
public:
  TemporaryFile() = default;
  ~TemporaryFile()
  {
    if (!this->Name.empty())
    {
      std::remove(this->Name.c_str());
    }
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  /// Whether it could be written.
  [[nodiscard]] bool write(const std::string& content)
  {
    std::error_code error;
    std::string name = (std::filesystem::temp_directory_path(error) / "stipple-XXXXXX").string();
    const int file = error ? -1 : mkstemp(&name[0]);
    if (file < 0)
    {
      return false;
    }
    close(file);
    this->Name = name;
    std::ofstream stream(name, std::ios::binary);
    return static_cast<bool>(stream << content << std::flush);
  }
  /// Empty unless written.
  const std::string& name() const { return this->Name; }

private:
  std::string Name;
};

Status readByVTK(vtkAlgorithm* reader, const std::string& file, vtkPolyData* mesh)
{
  ErrorCollector errors(reader);
  const MessageWatch others; // readers warn where they should fail: "Error reading binary data!"
  try
  {
    reader->Update();
  }
  catch (const std::bad_alloc&) // by counts within the data
  {
    return Status::error("cannot read '" + file + "': it asks for more memory than there is");
  }
  vtkDataObject* output = reader->GetOutputDataObject(0);
  vtkPolyData* read = vtkPolyData::SafeDownCast(output);
  const std::string sentence = errors.first().empty() ? others.firstError() : errors.first();
  if (read && sentence.empty())
  {
    mesh->ShallowCopy(read);
    return Status::success();
  }
  if (output && !read && std::string(output->GetClassName()) != "vtkDataObject")
  {
    return Status::error("'" + file + "' holds a " + output->GetClassName() +
      ", not a vtkPolyData: extract its surface first");
  }
  // Parts of a broken file may be in VTK's sentence.
  return Status::error(
    "cannot read '" + file + "'" + (sentence.empty() ? "" : ": " + printable(sentence, 200)));
}

/// vtkOBJReader has an array of texture coordinates for each material, named like it, with -1 at
/// the points of others: all in one, for no point is of two.
void joinTexture(vtkPolyData* mesh)
{
  vtkPointData* data = mesh->GetPointData();
  std::vector<vtkSmartPointer<vtkDataArray>> ofMaterials;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    if (array && array->GetNumberOfComponents() == 2)
    {
      ofMaterials.emplace_back(array);
    }
  }
  if (ofMaterials.empty())
  {
    return;
  }
  auto joined = vtkSmartPointer<vtkDataArray>::Take(ofMaterials.front()->NewInstance());
  joined->DeepCopy(ofMaterials.front());
  joined->SetName("TCoords");
  for (const auto& array : ofMaterials)
  {
    for (vtkIdType p = 0; p < joined->GetNumberOfTuples(); ++p)
    {
      if (array->GetComponent(p, 0) != -1. || array->GetComponent(p, 1) != -1.)
      {
        joined->SetTuple(p, p, array);
      }
    }
    data->RemoveArray(array->GetName());
  }
  data->SetTCoords(joined);
}

Status readObj(const std::string& file, vtkPolyData* mesh)
{
  const std::string content = contentOf(file);
  const std::string plain = plainObj(content);
  const std::string forVTK = withShortMaterials(plain);
  TemporaryFile copy;
  if (forVTK != content && !copy.write(forVTK))
  {
    return Status::error("cannot read '" + file + "': no temporary file can be written");
  }
  vtkNew<vtkOBJReader> reader;
  reader->SetFileName(copy.name().empty() ? file.c_str() : copy.name().c_str());
  Status status = readByVTK(reader, file, mesh);
  if (status.ok())
  {
    addObjRegions(plain, mesh);
    joinTexture(mesh);
  }
  return status;
}

Status readByExtension(const std::string& file, vtkPolyData* mesh)
{
  const std::string extension = fileExtension(file);
  if (extension == ".off")
  {
    return readOff(file, mesh);
  }
  if (extension == ".ply")
  {
    return readPly(file, mesh);
  }
  if (extension == ".obj")
  {
    return readObj(file, mesh);
  }
  if (extension == ".stl")
  {
    vtkNew<vtkSTLReader> reader;
    reader->SetFileName(file.c_str());
    reader->MergingOff(); // the atlas welds, and counts what it welded
    reader->ScalarTagsOn();
    Status status = readByVTK(reader, file, mesh);
    if (status.ok())
    {
      addStlSolids(file, mesh);
    }
    return status;
  }
  if (extension == ".vtp")
  {
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(file.c_str());
    return readByVTK(reader, file, mesh);
  }
  if (extension == ".vtk")
  {
    vtkNew<vtkGenericDataObjectReader> reader;
    reader->SetFileName(file.c_str());
    reader->ReadAllScalarsOn();
    reader->ReadAllVectorsOn();
    reader->ReadAllNormalsOn();
    reader->ReadAllTensorsOn();
    reader->ReadAllTCoordsOn();
    reader->ReadAllFieldsOn();
    return readByVTK(reader, file, mesh);
  }
  return Status::error("'" + file + "' has an unknown extension");
}

Status checkCells(const std::string& file, vtkPolyData* mesh)
{
  const vtkIdType numberOfPoints = mesh->GetNumberOfPoints();
  for (vtkCellArray* cells :
    { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(), mesh->GetStrips() })
  {
    for (vtkIdType c = 0; c < cells->GetNumberOfCells(); ++c)
    {
      vtkIdType size;
      const vtkIdType* ids;
      cells->GetCellAtId(c, size, ids);
      for (vtkIdType k = 0; k < size; ++k)
      {
        if (ids[k] < 0 || ids[k] >= numberOfPoints)
        {
          return Status::error("face " + std::to_string(c) + " of '" + file + "' names point " +
            std::to_string(ids[k]) + ", but there are " + std::to_string(numberOfPoints) +
            " points, from 0");
        }
      }
    }
  }
  return Status::success();
}

Status checkPoints(const std::string& file, vtkPolyData* mesh)
{
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    double x[3];
    mesh->GetPoint(p, x);
    if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
    {
      return Status::error("point " + std::to_string(p) + " of '" + file + "' lies at (" +
        shortestText(x[0]) + ", " + shortestText(x[1]) + ", " + shortestText(x[2]) +
        "): every coordinate must be finite");
    }
  }
  return Status::success();
}

Status checkFaces(const std::string& file, vtkPolyData* mesh)
{
  if (mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() > 0)
  {
    return Status::success();
  }
  if (mesh->GetNumberOfLines() > 0)
  {
    return Status::error("'" + file + "' holds only lines, no faces");
  }
  return Status::error(mesh->GetNumberOfPoints() > 0 ? "'" + file + "' holds only points, no faces"
                                                     : "'" + file + "' holds an empty mesh");
}

Status checkLines(const std::string& file, vtkPolyData* curves)
{
  return curves->GetNumberOfLines() > 0 ? Status::success()
                                        : Status::error("'" + file + "' holds no lines");
}

using Check = Status (*)(const std::string&, vtkPolyData*);

Status readChecked(
  const std::string& file, vtkSmartPointer<vtkPolyData>& data, const std::vector<Check>& checks)
{
  data = vtkSmartPointer<vtkPolyData>::New();
  std::error_code code;
  if (!std::filesystem::exists(file, code))
  {
    return Status::error("there is no file '" + file + "'");
  }
  if (std::filesystem::is_directory(file, code))
  {
    return Status::error("cannot read '" + file + "': it is a folder");
  }
  if (!canBeRead(file))
  {
    return Status::error("cannot read '" + file + "'");
  }
  if (std::filesystem::is_regular_file(file, code) && std::filesystem::file_size(file, code) == 0)
  {
    return Status::error("'" + file + "' is empty");
  }
  Status status = checkFile(file, fileExtension(file));
  if (status.ok())
  {
    status = readByExtension(file, data);
  }
  for (const Check& check : checks)
  {
    if (status.ok())
    {
      status = check(file, data);
    }
  }
  return status;
}

/// The texture coordinates of a mesh's corners in an OBJ file: each pair once.
class ObjTexture
{
public:
  ObjTexture(vtkPolyData* mesh, std::ostream& stream)
  {
    vtkDataArray* corners = cornerTexture(mesh);
    std::map<std::pair<double, double>, std::size_t> numbers;
    for (vtkIdType f = 0; corners && f < mesh->GetNumberOfPolys(); ++f)
    {
      const vtkIdType size = mesh->GetPolys()->GetCellSize(f);
      this->First.push_back(this->Number.size());
      for (int k = 0; k < size; ++k)
      {
        const Vec2 uv = textureOfCorner(corners, f, k);
        const auto [entry, fresh] = numbers.try_emplace({ uv.x(), uv.y() }, numbers.size() + 1);
        if (fresh)
        {
          stream << "vt " << shortestText(uv.x()) << ' ' << shortestText(uv.y()) << '\n';
        }
        this->Number.push_back(entry->second);
      }
    }
  }
  /// What follows the number of a corner's point.
  std::string of(vtkIdType face, vtkIdType corner) const
  {
    return this->First.empty() ? std::string()
                               : '/' +
        std::to_string(this->Number[this->First[static_cast<std::size_t>(face)] +
          static_cast<std::size_t>(corner)]);
  }

private:
  std::vector<std::size_t> First; // by face, of its corners
  std::vector<std::size_t> Number;
};

/// VTK 9.1's writer keeps six digits.
bool writeObj(vtkPolyData* mesh, const std::string& file)
{
  std::ofstream stream(file, std::ios::binary);
  stream << "# Stipple\n";
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    double x[3];
    mesh->GetPoint(p, x);
    stream << "v " << shortestText(x[0]) << ' ' << shortestText(x[1]) << ' ' << shortestText(x[2])
           << '\n';
  }
  const ObjTexture texture(mesh, stream);
  const MeshRegions regions(mesh);
  if (const std::string library = objMaterialLibrary(mesh, regions); !library.empty())
  {
    stream << "mtllib " << library << '\n';
  }
  const auto writeFace = [&](vtkIdType f) {
    vtkIdType size;
    const vtkIdType* ids;
    mesh->GetPolys()->GetCellAtId(f, size, ids);
    stream << 'f';
    for (vtkIdType k = 0; k < size; ++k)
    {
      stream << ' ' << ids[k] + 1 << texture.of(f, k);
    }
    stream << '\n';
  };
  for (std::size_t r = 0; r < regions.names().size(); ++r)
  {
    stream << objRegionLine(regions, r);
    std::for_each(regions.cells()[r].begin(), regions.cells()[r].end(), writeFace);
  }
  for (vtkIdType f = 0; regions.empty() && f < mesh->GetNumberOfPolys(); ++f)
  {
    writeFace(f);
  }
  stream.close();
  return static_cast<bool>(stream);
}

/// Whoever asked for an array's range has left it in the array's information, which VTK's files
/// have, too.
vtkSmartPointer<vtkDataArray> withoutRange(vtkDataArray* array)
{
  auto bare = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
  bare->ShallowCopy(array);
  bare->SetName(array->GetName());
  return bare;
}

void forgetRanges(vtkFieldData* data)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    if (vtkDataArray* array = data->GetArray(i))
    {
      data->AddArray(withoutRange(array));
    }
  }
}

/// The same file for the same mesh, whatever was done with it meanwhile.
template <typename WriterT>
bool writeByVTK(WriterT* writer, vtkPolyData* mesh, const std::string& file)
{
  vtkNew<vtkPolyData> bare;
  bare->ShallowCopy(mesh);
  vtkNew<vtkPoints> points;
  if (mesh->GetPoints())
  {
    points->SetData(withoutRange(mesh->GetPoints()->GetData()));
  }
  bare->SetPoints(points);
  forgetRanges(bare->GetPointData());
  forgetRanges(bare->GetCellData());
  forgetRanges(bare->GetFieldData());
  ErrorCollector errors(writer);
  writer->SetFileName(file.c_str());
  writer->SetInputData(bare);
  return writer->Write() && writer->GetErrorCode() == 0 && errors.first().empty();
}

/// Whether it was written.
bool writeByExtension(vtkPolyData* mesh, const std::string& file, const std::string& extension)
{
  if (extension == ".off")
  {
    return writeOff(mesh, file);
  }
  if (extension == ".ply")
  {
    return writePly(mesh, file);
  }
  if (extension == ".obj")
  {
    return writeObj(mesh, file);
  }
  if (extension == ".stl")
  {
    if (const MeshRegions regions(mesh); !regions.empty())
    {
      return writeStlSolids(mesh, regions, file);
    }
    vtkNew<vtkSTLWriter> writer;
    writer->SetFileTypeToBinary();
    return writeByVTK(writer.Get(), mesh, file);
  }
  if (extension == ".vtp")
  {
    vtkNew<vtkXMLPolyDataWriter> writer;
    return writeByVTK(writer.Get(), withXmlNames(mesh).Get(), file);
  }
  if (extension == ".vtk")
  {
    vtkNew<vtkPolyDataWriter> writer;
    writer->SetFileTypeToBinary();
    return writeByVTK(writer.Get(), mesh, file);
  }
  return false;
}
}

const std::vector<std::string>& meshFileExtensions()
{
  static const std::vector<std::string> extensions = { ".ply", ".obj", ".stl", ".off", ".vtp",
    ".vtk" };
  return extensions;
}

std::string fileExtension(const std::string& file)
{
  std::string extension = std::filesystem::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

Status readMesh(const std::string& file, vtkSmartPointer<vtkPolyData>& mesh)
{
  return readChecked(file, mesh, { checkCells, checkPoints, checkFaces });
}

Status readCurves(const std::string& file, vtkSmartPointer<vtkPolyData>& curves)
{
  return readChecked(file, curves, { checkCells, checkPoints, checkLines });
}

bool keepsRegions(const std::string& extension)
{
  return extension != ".off";
}

bool keepsTexture(const std::string& extension)
{
  return extension != ".off" && extension != ".stl";
}

Status writeRemesh(vtkPolyData* mesh, const std::string& file, const std::string& target)
{
  const std::string extension = fileExtension(target.empty() ? file : target);
  const bool ofPoints = extension == ".vtp" || extension == ".vtk";
  return writeMesh(ofPoints ? splitTextureSeams(mesh).Get() : mesh, file, target);
}

Status writeMesh(vtkPolyData* mesh, const std::string& file, const std::string& target)
{
  const std::string& name = target.empty() ? file : target;
  return writeByExtension(mesh, file, fileExtension(name))
    ? Status::success()
    : Status::error("cannot write '" + name + "'");
}
}
