// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BlockTree.h"

#include "BlockGhosts.h"
#include "PieceBorders.h"

#include "vtkAppendPolyData.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <map>

namespace stipple
{
namespace
{
constexpr const char* BlockIds = "BlockId";

class Collector
{
public:
  int Port;
  Taken Kind;
  std::vector<BlockPiece>& Pieces;
  std::vector<unsigned long long>& Version;

  Status visit(vtkDataObject* data, const BlockPath& path)
  {
    if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(data))
    {
      for (unsigned int i = 0; i < blocks->GetNumberOfBlocks(); ++i)
      {
        if (Status status = this->visit(blocks->GetBlock(i), below(path, i, memberName(blocks, i)));
            !status.ok())
        {
          return status;
        }
      }
      return Status::success();
    }
    if (auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(data))
    {
      for (unsigned int i = 0; i < collection->GetNumberOfPartitionedDataSets(); ++i)
      {
        if (Status status = this->visit(
              collection->GetPartitionedDataSet(i), below(path, i, memberName(collection, i)));
            !status.ok())
        {
          return status;
        }
      }
      return Status::success();
    }
    if (auto* parts = vtkPartitionedDataSet::SafeDownCast(data)) // a vtkMultiPieceDataSet, too
    {
      this->add(nullptr, path); // though it may have no part here
      for (unsigned int i = 0; i < parts->GetNumberOfPartitions(); ++i)
      {
        if (Status status = this->visitLeaf(parts->GetPartitionAsDataObject(i), path); !status.ok())
        {
          return status;
        }
      }
      return Status::success();
    }
    return this->visitLeaf(data, path);
  }

private:
  static BlockPath below(BlockPath path, unsigned int index, const std::string& name)
  {
    path.indices.push_back(static_cast<int>(index));
    path.names.push_back(name);
    return path;
  }

  void add(const vtkSmartPointer<vtkPolyData>& data, const BlockPath& path)
  {
    this->Pieces.push_back({ this->Port, path, data });
  }

  Status visitLeaf(vtkDataObject* data, const BlockPath& path)
  {
    this->Version.push_back(reinterpret_cast<unsigned long long>(data));
    this->Version.push_back(data ? data->GetMTime() : 0);
    if (!data)
    {
      this->add(nullptr, path);
      return Status::success();
    }
    vtkNew<vtkPolyData> piece;
    if (auto* surface = vtkPolyData::SafeDownCast(data))
    {
      piece->ShallowCopy(withoutGhosts(surface));
    }
    else if (auto* points = vtkPointSet::SafeDownCast(data); points && this->Kind == Taken::Points)
    {
      piece->SetPoints(points->GetPoints());
      piece->GetPointData()->ShallowCopy(points->GetPointData());
      piece->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
    }
    else
    {
      return Status::error((path.indices.empty() ? "The input" : "The input's " + nameOf(path)) +
        " is a " + data->GetClassName() +
        (this->Kind == Taken::Points ? ", not a set of points."
                                     : ", not a surface: apply Extract Surface to it first."));
    }
    this->add(piece.Get(), path);
    return Status::success();
  }
};

bool isEmpty(vtkPolyData* data)
{
  return !data || (data->GetNumberOfPoints() == 0 && data->GetNumberOfCells() == 0);
}

vtkSmartPointer<vtkPolyData> append(const std::vector<vtkSmartPointer<vtkPolyData>>& parts)
{
  vtkNew<vtkAppendPolyData> append;
  for (const auto& part : parts)
  {
    append->AddInputData(part);
  }
  append->Update();
  return append->GetOutput();
}

vtkSmartPointer<vtkPolyData> withBlockId(vtkPolyData* data, int id)
{
  auto part = vtkSmartPointer<vtkPolyData>::New();
  part->ShallowCopy(data);
  vtkNew<vtkIntArray> ids;
  ids->SetName(BlockIds);
  ids->SetNumberOfValues(part->GetNumberOfCells());
  ids->FillValue(id);
  part->GetCellData()->AddArray(ids);
  return part;
}

/// The child of a tree's node that is a node itself; made if there is none.
vtkMultiBlockDataSet* nodeBelow(vtkMultiBlockDataSet* node, unsigned int index)
{
  auto* child = vtkMultiBlockDataSet::SafeDownCast(
    index < node->GetNumberOfBlocks() ? node->GetBlock(index) : nullptr);
  if (!child)
  {
    vtkNew<vtkMultiBlockDataSet> made;
    node->SetBlock(index, made);
    child = made; // the node keeps it
  }
  return child;
}
}

std::string nameOf(const BlockPath& path)
{
  std::string numbers;
  for (const int index : path.indices)
  {
    numbers += (numbers.empty() ? "" : ".") + std::to_string(index);
  }
  const std::string& name = path.names.empty() ? numbers : path.names.back();
  return name.empty() ? "block " + numbers : "block '" + name + "'";
}

Status collectPieces(vtkDataObject* input, int port, Taken taken, std::vector<BlockPiece>& pieces,
  std::vector<unsigned long long>& version)
{
  return Collector{ port, taken, pieces, version }.visit(input, BlockPath());
}

std::vector<Block> joinBlocks(const std::vector<BlockPiece>& pieces, int port)
{
  std::map<std::vector<int>, std::vector<const BlockPiece*>> byPath;
  for (const BlockPiece& piece : pieces)
  {
    if (piece.port == port)
    {
      byPath[piece.path.indices].push_back(&piece);
    }
  }
  std::vector<Block> blocks;
  for (const auto& [path, parts] : byPath)
  {
    std::vector<vtkSmartPointer<vtkPolyData>> full;
    for (const BlockPiece* part : parts)
    {
      if (!isEmpty(part->data))
      {
        full.push_back(part->data);
      }
    }
    blocks.push_back({ parts.front()->path,
      full.empty()         ? parts.front()->data
        : full.size() == 1 ? full.front()
                           : joinPieces(full, append(full)) });
  }
  return blocks;
}

vtkSmartPointer<vtkPolyData> mergeBlocks(const std::vector<Block>& blocks)
{
  std::vector<vtkSmartPointer<vtkPolyData>> full;
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    if (!isEmpty(blocks[i].data))
    {
      full.push_back(
        blocks.size() > 1 ? withBlockId(blocks[i].data, static_cast<int>(i)) : blocks[i].data);
    }
  }
  return full.empty()  ? vtkSmartPointer<vtkPolyData>::New()
    : full.size() == 1 ? full.front()
                       : append(full);
}

void numberPieces(const std::vector<Block>& blocks, std::vector<BlockPiece>& pieces)
{
  if (blocks.size() < 2)
  {
    return;
  }
  std::map<std::vector<int>, int> numbers;
  for (const Block& block : blocks)
  {
    numbers.emplace(block.path.indices, static_cast<int>(numbers.size()));
  }
  for (BlockPiece& piece : pieces)
  {
    if (!isEmpty(piece.data))
    {
      piece.data = withBlockId(piece.data, numbers.at(piece.path.indices));
      piece.data->GetPointData()->SetGlobalIds(nullptr); // each block may count from 0
    }
  }
}

void fillTree(const std::vector<Block>& blocks, vtkDataObject* tree)
{
  tree->Initialize();
  if (auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(tree))
  {
    for (const Block& block : blocks)
    {
      const auto index = static_cast<unsigned int>(block.path.indices.front());
      collection->SetPartition(index, 0, block.data);
      if (const std::string& name = block.path.names.front(); !name.empty())
      {
        collection->GetMetaData(index)->Set(vtkCompositeDataSet::NAME(), name.c_str());
      }
    }
    return;
  }
  for (const Block& block : blocks)
  {
    auto* node = vtkMultiBlockDataSet::SafeDownCast(tree);
    for (std::size_t level = 0; node && level < block.path.indices.size(); ++level)
    {
      const auto index = static_cast<unsigned int>(block.path.indices[level]);
      const bool isLeaf = level + 1 == block.path.indices.size();
      vtkMultiBlockDataSet* below = isLeaf ? nullptr : nodeBelow(node, index);
      if (isLeaf)
      {
        node->SetBlock(index, block.data);
      }
      if (const std::string& name = block.path.names[level]; !name.empty())
      {
        node->GetMetaData(index)->Set(vtkCompositeDataSet::NAME(), name.c_str());
      }
      node = below;
    }
  }
}
}
