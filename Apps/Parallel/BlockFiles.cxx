// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BlockFiles.h"

#include "MeshFile.h"
#include "OptionTable.h"
#include "XmlNames.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCharArray.h"
#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLPolyDataWriter.h"
#include "vtkXMLUtilities.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace stipple
{
namespace
{
namespace fs = std::filesystem;

/// Files that an element or one inside names.
void collect(vtkXMLDataElement* element, std::vector<std::string>& names)
{
  const std::string kind = element->GetName() ? element->GetName() : "";
  const char* name = kind == "Piece" ? element->GetAttribute("Source")
    : kind == "DataSet"              ? element->GetAttribute("file")
                                     : nullptr;
  if (name)
  {
    names.emplace_back(name);
  }
  for (int i = 0; i < element->GetNumberOfNestedElements(); ++i)
  {
    collect(element->GetNestedElement(i), names);
  }
}

Status readPieceNames(const std::string& file, std::vector<std::string>& pieces)
{
  auto root =
    vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromFile(file.c_str()));
  if (!root)
  {
    return Status::error("cannot read '" + file + "'");
  }
  const std::string type = root->GetAttribute("type") ? root->GetAttribute("type") : "";
  if (type != "PPolyData" && type != "vtkPartitionedDataSet")
  {
    return Status::error("'" + file + "' holds no pieces of a surface, but '" + type + "'");
  }
  collect(root, pieces);
  for (std::string& piece : pieces)
  {
    piece = (fs::path(file).parent_path() / piece).string();
    if (fileExtension(piece) != ".vtp")
    {
      return Status::error("'" + file + "' names '" + piece + "', which is no .vtp file");
    }
  }
  return pieces.empty() ? Status::error("'" + file + "' names no piece") : Status::success();
}

std::string joined(const std::vector<std::string>& words)
{
  std::string text;
  for (const std::string& word : words)
  {
    text += word + '\0';
  }
  return text;
}

/// All blocks as one, points in the order of their global ids.
vtkSmartPointer<vtkPolyData> join(const std::vector<vtkSmartPointer<vtkPolyData>>& blocks)
{
  vtkNew<vtkAppendPolyData> append;
  append->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  std::vector<vtkIdType> ids;
  for (vtkPolyData* block : blocks)
  {
    vtkDataArray* global = block->GetPointData()->GetGlobalIds();
    for (vtkIdType p = 0; p < block->GetNumberOfPoints(); ++p)
    {
      ids.push_back(static_cast<vtkIdType>(global->GetComponent(p, 0)));
    }
    append->AddInputData(block);
  }
  append->Update();
  vtkPolyData* all = append->GetOutput();
  auto result = vtkSmartPointer<vtkPolyData>::New();
  const vtkIdType n = ids.empty() ? 0 : *std::max_element(ids.begin(), ids.end()) + 1;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(n);
  result->GetPointData()->CopyAllOn();
  result->GetPointData()->CopyAllocate(all->GetPointData(), n);
  for (vtkIdType p = 0; p < all->GetNumberOfPoints(); ++p)
  {
    points->SetPoint(ids[static_cast<std::size_t>(p)], all->GetPoint(p));
    result->GetPointData()->CopyData(all->GetPointData(), p, ids[static_cast<std::size_t>(p)]);
  }
  vtkNew<vtkCellArray> cells;
  vtkIdType size;
  const vtkIdType* corners;
  for (vtkIdType t = 0; t < all->GetNumberOfPolys(); ++t)
  {
    all->GetPolys()->GetCellAtId(t, size, corners);
    cells->InsertNextCell({ ids[static_cast<std::size_t>(corners[0])],
      ids[static_cast<std::size_t>(corners[1])], ids[static_cast<std::size_t>(corners[2])] });
  }
  result->SetPoints(points);
  result->SetPolys(cells);
  result->GetCellData()->ShallowCopy(all->GetCellData());
  return result;
}

Status writeJoined(vtkPartitionedDataSet* blocks, const std::string& file,
  const RankMessages& ranks, OutputFiles& files)
{
  std::vector<Bytes> messages(static_cast<std::size_t>(ranks.size()));
  std::vector<vtkSmartPointer<vtkPolyData>> own;
  for (unsigned int b = 0; b < blocks->GetNumberOfPartitions(); ++b)
  {
    auto* block = vtkPolyData::SafeDownCast(blocks->GetPartitionAsDataObject(b));
    if (!block)
    {
      continue;
    }
    if (ranks.rank() == 0)
    {
      own.emplace_back(block);
      continue;
    }
    vtkNew<vtkCharArray> packed;
    vtkCommunicator::MarshalDataObject(block, packed);
    const long long size = packed->GetNumberOfValues();
    const auto* head = reinterpret_cast<const char*>(&size);
    messages[0].insert(messages[0].end(), head, head + sizeof size);
    messages[0].insert(messages[0].end(), packed->GetPointer(0), packed->GetPointer(0) + size);
  }
  const std::vector<Bytes> received = ranks.exchange(std::move(messages));
  if (ranks.rank() != 0)
  {
    return Status::success();
  }
  for (std::size_t r = 1; r < received.size(); ++r) // blocks are dealt in a row
  {
    for (std::size_t at = 0; at < received[r].size();)
    {
      long long size = 0;
      std::memcpy(&size, received[r].data() + at, sizeof size);
      at += sizeof size;
      vtkNew<vtkCharArray> packed;
      packed->SetNumberOfValues(size);
      std::copy_n(received[r].data() + at, size, packed->GetPointer(0));
      at += static_cast<std::size_t>(size);
      own.emplace_back(
        vtkPolyData::SafeDownCast(vtkCommunicator::UnMarshalDataObject(packed).GetPointer()));
    }
  }
  return writeMesh(join(own), files.aside(file), file);
}

std::string pieceName(const std::string& file, unsigned int block)
{
  const std::string stem = fs::path(file).stem().string();
  return stem + "_" + std::to_string(block) + ".vtp";
}

Status writePieces(vtkPartitionedDataSet* blocks, const std::string& file, int ghostLevels,
  const RankMessages& ranks, OutputFiles& files)
{
  const fs::path target = fs::path(file).parent_path() / fs::path(file).stem();
  Status status = Status::success();
  std::vector<unsigned int> own;
  std::string folder;
  for (unsigned int b = 0; b < blocks->GetNumberOfPartitions() && status.ok(); ++b)
  {
    auto* block = vtkPolyData::SafeDownCast(blocks->GetPartitionAsDataObject(b));
    if (!block)
    {
      continue;
    }
    if (folder.empty())
    {
      status = files.asideFolder(target.string(), folder);
      if (!status.ok())
      {
        break;
      }
    }
    own.push_back(b);
    vtkNew<vtkXMLPolyDataWriter> writer;
    const std::string name = (fs::path(folder) / pieceName(file, b)).string();
    writer->SetFileName(name.c_str());
    writer->SetInputData(withXmlNames(block));
    if (writer->Write() == 0 || writer->GetErrorCode() != 0)
    {
      status = Status::error("cannot write '" + (target / pieceName(file, b)).string() + "'");
    }
  }
  if (Status all = ranks.agree(status); !all.ok())
  {
    return all;
  }
  const std::vector<unsigned int> written = ranks.gatherAll(own);
  if (ranks.rank() != 0)
  {
    return Status::success();
  }
  const std::string stem = target.filename().string();
  std::ofstream index(files.aside(file), std::ios::binary);
  index << "<?xml version=\"1.0\"?>\n";
  if (fileExtension(file) == ".vtpd")
  {
    index << "<VTKFile type=\"vtkPartitionedDataSet\" version=\"1.0\" byte_order=\"LittleEndian\" "
             "header_type=\"UInt32\">\n  <vtkPartitionedDataSet>\n";
    for (std::size_t i = 0; i < written.size(); ++i)
    {
      index << "    <DataSet index=\"" << i << "\" file=\"" << stem << "/"
            << pieceName(file, written[i]) << "\"/>\n";
    }
    index << "  </vtkPartitionedDataSet>\n</VTKFile>\n";
  }
  else
  {
    // The arrays, as any piece has them: told by the first block, which the first rank has.
    auto* first = vtkPolyData::SafeDownCast(blocks->GetPartitionAsDataObject(written.front()));
    index << "<VTKFile type=\"PPolyData\" version=\"0.1\" byte_order=\"LittleEndian\" "
             "header_type=\"UInt32\">\n  <PPolyData GhostLevel=\""
          << ghostLevels << "\">\n";
    const auto tell = [&](const char* name, vtkDataSetAttributes* data, const char* active) {
      index << "    <" << name << active << ">\n";
      for (int a = 0; first && a < data->GetNumberOfArrays(); ++a)
      {
        vtkAbstractArray* array = data->GetAbstractArray(a);
        const bool isText = array->GetDataType() == VTK_STRING;
        const bool isReal = array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
        index << "      <PDataArray type=\""
              << (isText ? std::string("String")
                     : isReal
                     ? "Float" + std::to_string(8 * array->GetDataTypeSize())
                     : (vtkDataArray::SafeDownCast(array)->GetDataTypeMin() < 0 ? "Int" : "UInt") +
                       std::to_string(8 * array->GetDataTypeSize()))
              << "\" Name=\"" << xmlName(array->GetName()) << "\" NumberOfComponents=\""
              << array->GetNumberOfComponents() << "\"/>\n";
      }
      index << "    </" << name << ">\n";
    };
    tell("PPointData", first->GetPointData(), " GlobalIds=\"GlobalPointIds\"");
    tell("PCellData", first->GetCellData(), "");
    index << "    <PPoints>\n      <PDataArray type=\"Float64\" Name=\"Points\" "
             "NumberOfComponents=\"3\"/>\n    </PPoints>\n";
    for (const unsigned int b : written)
    {
      index << "    <Piece Source=\"" << stem << "/" << pieceName(file, b) << "\"/>\n";
    }
    index << "  </PPolyData>\n</VTKFile>\n";
  }
  index.close();
  return index ? Status::success() : Status::error("cannot write '" + file + "'");
}
}

const std::vector<std::string>& pieceFileExtensions()
{
  static const std::vector<std::string> extensions = { ".pvtp", ".vtpd" };
  return extensions;
}

bool isPieceFile(const std::string& file)
{
  const auto& kinds = pieceFileExtensions();
  return std::find(kinds.begin(), kinds.end(), fileExtension(file)) != kinds.end();
}

Status findPieces(
  const std::string& file, const RankMessages& ranks, std::vector<std::string>& pieces)
{
  pieces.clear();
  Status status = Status::success();
  Bytes names;
  if (ranks.rank() == 0)
  {
    std::vector<std::string> found;
    if (isPieceFile(file))
    {
      status = readPieceNames(file, found);
    }
    else
    {
      found.push_back(file);
    }
    const std::string text = joined(found);
    names.assign(text.begin(), text.end());
  }
  status = ranks.agree(status);
  const std::vector<Bytes> ofRanks = ranks.gather(names);
  for (auto begin = ofRanks[0].begin(); begin != ofRanks[0].end();)
  {
    const auto end = std::find(begin, ofRanks[0].end(), '\0');
    pieces.emplace_back(begin, end);
    begin = end + 1;
  }
  return status;
}

SurfacePieces shareOfPieces(const std::vector<std::string>& pieces, const RankMessages& ranks)
{
  const auto n = static_cast<long long>(pieces.size());
  const long long first = n * ranks.rank() / ranks.size();
  const long long last = n * (ranks.rank() + 1) / ranks.size();
  SurfacePieces result;
  result.count = static_cast<int>(last - first);
  result.read = [pieces, first](int i, vtkSmartPointer<vtkPolyData>& piece) {
    const std::string& file = pieces[static_cast<std::size_t>(first + i)];
    return readMesh(file, piece);
  };
  return result;
}

Status writeBlockFiles(vtkPartitionedDataSet* blocks, const std::string& file, int ghostLevels,
  const RankMessages& ranks, OutputFiles& files)
{
  return isPieceFile(file) ? writePieces(blocks, file, ghostLevels, ranks, files)
                           : writeJoined(blocks, file, ranks, files);
}
}
