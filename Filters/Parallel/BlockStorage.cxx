// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BlockStorage.h"

#include "vtkCharArray.h"
#include "vtkCommunicator.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <fstream>
#include <stdexcept>

namespace stipple
{
Bytes pack(vtkPolyData* data)
{
  vtkNew<vtkCharArray> packed;
  vtkCommunicator::MarshalDataObject(data, packed);
  return { packed->GetPointer(0), packed->GetPointer(0) + packed->GetNumberOfValues() };
}

vtkSmartPointer<vtkPolyData> unpack(const Bytes& bytes)
{
  vtkNew<vtkCharArray> packed;
  packed->SetNumberOfValues(static_cast<vtkIdType>(bytes.size()));
  std::copy(bytes.begin(), bytes.end(), packed->GetPointer(0));
  return vtkPolyData::SafeDownCast(vtkCommunicator::UnMarshalDataObject(packed).GetPointer());
}

void writeBytes(std::ofstream& file, const Bytes& bytes)
{
  const auto size = static_cast<long long>(bytes.size());
  file.write(reinterpret_cast<const char*>(&size), sizeof size);
  file.write(bytes.data(), static_cast<std::streamsize>(size));
}

Bytes readBytes(std::ifstream& file)
{
  long long size = 0;
  file.read(reinterpret_cast<char*>(&size), sizeof size);
  Bytes bytes(static_cast<std::size_t>(file ? size : 0));
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!file)
  {
    throw std::runtime_error("a block's file cannot be read");
  }
  return bytes;
}

namespace
{
template <typename T>
std::vector<T> readValues(std::ifstream& file)
{
  std::vector<T> values;
  RankMessages::append(readBytes(file), values);
  return values;
}
}

void park(SurfaceBlock& block)
{
  if (block.file.empty())
  {
    return;
  }
  std::ofstream file(block.file, std::ios::binary);
  writeBytes(file, pack(block.data));
  writeBytes(file, RankMessages::bytesOf(block.pointId));
  writeBytes(file, RankMessages::bytesOf(block.triangleId));
  writeBytes(file, RankMessages::bytesOf(block.owner));
  writeBytes(file, RankMessages::bytesOf(block.cellId));
  file.close();
  if (!file)
  {
    throw std::runtime_error("cannot write '" + block.file + "'");
  }
  SurfaceBlock left;
  left.number = block.number;
  left.numberOfOwn = block.numberOfOwn;
  left.file = block.file;
  block = std::move(left);
}

BlockInMemory::BlockInMemory(const SurfaceBlock& block)
  : Block(&block)
{
  if (block.file.empty())
  {
    return;
  }
  this->Read = std::make_unique<SurfaceBlock>();
  this->Block = this->Read.get();
  this->Read->number = block.number;
  this->Read->numberOfOwn = block.numberOfOwn;
  std::ifstream file(block.file, std::ios::binary);
  this->Read->data = unpack(readBytes(file));
  this->Read->pointId = readValues<long long>(file);
  this->Read->triangleId = readValues<long long>(file);
  this->Read->owner = readValues<int>(file);
  this->Read->cellId = readValues<long long>(file);
}

BlockInMemory::~BlockInMemory() = default;
}
