// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RankExchange.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"
#include "vtkPartitionedDataSetCollection.h"

namespace stipple
{
namespace
{
constexpr int Root = 0;
constexpr int StreamTag = 40101;
constexpr int DataTag = 40102;

void write(vtkMultiProcessStream& stream, const BlockPath& path)
{
  stream << static_cast<int>(path.indices.size());
  for (std::size_t i = 0; i < path.indices.size(); ++i)
  {
    stream << path.indices[i] << path.names[i];
  }
}

BlockPath readPath(vtkMultiProcessStream& stream)
{
  BlockPath path;
  int size = 0;
  stream >> size;
  for (int i = 0; i < size; ++i)
  {
    path.indices.emplace_back();
    path.names.emplace_back();
    stream >> path.indices.back() >> path.names.back();
  }
  return path;
}
}

RankExchange::RankExchange()
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  this->Controller = controller && controller->GetNumberOfProcesses() > 1 ? controller : nullptr;
}

bool RankExchange::isRoot() const
{
  return !this->Controller || this->Controller->GetLocalProcessId() == Root;
}

void RankExchange::agree(bool& any, std::string& sentence) const
{
  if (!this->Controller)
  {
    return;
  }
  vtkMultiProcessStream own;
  own << any << sentence;
  std::vector<vtkMultiProcessStream> all;
  this->Controller->Gather(own, all, Root);
  vtkMultiProcessStream verdict;
  if (this->isRoot())
  {
    sentence.clear();
    for (vtkMultiProcessStream& stream : all)
    {
      bool one = false;
      std::string said;
      stream >> one >> said;
      any = any || one;
      sentence = sentence.empty() ? said : sentence;
    }
    verdict << any << sentence;
  }
  this->Controller->Broadcast(verdict, Root);
  verdict >> any >> sentence;
}

void RankExchange::gather(std::vector<BlockPiece>& pieces) const
{
  if (!this->Controller)
  {
    return;
  }
  if (!this->isRoot())
  {
    vtkMultiProcessStream stream;
    stream << static_cast<int>(pieces.size());
    for (const BlockPiece& piece : pieces)
    {
      stream << piece.port << (piece.data != nullptr);
      write(stream, piece.path);
    }
    this->Controller->Send(stream, Root, StreamTag);
    for (const BlockPiece& piece : pieces)
    {
      if (piece.data)
      {
        this->Controller->Send(piece.data, Root, DataTag);
      }
    }
    pieces.clear();
    return;
  }
  for (int rank = 1; rank < this->Controller->GetNumberOfProcesses(); ++rank)
  {
    vtkMultiProcessStream stream;
    this->Controller->Receive(stream, rank, StreamTag);
    int size = 0;
    stream >> size;
    for (int i = 0; i < size; ++i)
    {
      BlockPiece piece;
      bool hasData = false;
      stream >> piece.port >> hasData;
      piece.path = readPath(stream);
      if (hasData)
      {
        piece.data = vtkSmartPointer<vtkPolyData>::New();
        this->Controller->Receive(piece.data, rank, DataTag);
      }
      pieces.push_back(piece);
    }
  }
}

void RankExchange::share(std::vector<std::string>& words) const
{
  if (!this->Controller)
  {
    return;
  }
  vtkMultiProcessStream stream;
  stream << static_cast<int>(words.size());
  for (const std::string& word : words)
  {
    stream << word;
  }
  this->Controller->Broadcast(stream, Root);
  int size = 0;
  stream >> size;
  words.resize(static_cast<std::size_t>(size));
  for (std::string& word : words)
  {
    stream >> word;
  }
}

void RankExchange::share(std::vector<Block>& blocks) const
{
  if (!this->Controller)
  {
    return;
  }
  vtkMultiProcessStream stream;
  stream << static_cast<int>(blocks.size());
  for (const Block& block : blocks)
  {
    stream << (block.data != nullptr);
    write(stream, block.path);
  }
  this->Controller->Broadcast(stream, Root);
  if (this->isRoot())
  {
    return;
  }
  int size = 0;
  stream >> size;
  blocks.clear();
  for (int i = 0; i < size; ++i)
  {
    Block block;
    bool hasData = false;
    stream >> hasData;
    block.path = readPath(stream);
    block.data = hasData ? vtkSmartPointer<vtkPolyData>::New() : nullptr;
    blocks.push_back(block);
  }
}

void RankExchange::share(vtkPartitionedDataSetCollection* collection) const
{
  if (!this->Controller || !collection)
  {
    return;
  }
  std::vector<std::string> names;
  for (unsigned int i = 0; i < collection->GetNumberOfPartitionedDataSets(); ++i)
  {
    names.push_back(memberName(collection, i));
  }
  this->share(names);
  if (this->isRoot())
  {
    return;
  }
  collection->SetNumberOfPartitionedDataSets(static_cast<unsigned int>(names.size()));
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    if (!names[i].empty())
    {
      collection->GetMetaData(static_cast<unsigned int>(i))
        ->Set(vtkCompositeDataSet::NAME(), names[i].c_str());
    }
  }
}

int runOnRoot(vtkInformationVector* output, const std::function<int()>& work)
{
  const RankExchange ranks;
  if (ranks.isRoot())
  {
    work();
  }
  for (int port = 0; port < output->GetNumberOfInformationObjects(); ++port)
  {
    ranks.share(vtkPartitionedDataSetCollection::GetData(output, port));
  }
  return 1;
}
}
