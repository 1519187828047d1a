// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Data of blocks as a list, and back: what ParaView calls composite data.
#ifndef stipple_BlockTree_h
#define stipple_BlockTree_h

#include "Progress.h"

#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkDataObject;

namespace stipple
{
/// Where a block lies in a tree of blocks: the index and the name at each level, from the root.
/// Data that are no tree have one block with an empty path.
struct BlockPath
{
  std::vector<int> indices;
  std::vector<std::string> names; ///< empty where there is none
};

/// The block as people know it: "wing", or "block 3" where it has no name.
std::string nameOf(const BlockPath& path);

/// The name of a member of a vtkMultiBlockDataSet or a vtkPartitionedDataSetCollection; empty if it
/// has none.
template <typename Tree>
std::string memberName(Tree* tree, unsigned int index)
{
  const char* name =
    tree->HasMetaData(index) ? tree->GetMetaData(index)->Get(vtkCompositeDataSet::NAME()) : nullptr;
  return name ? name : "";
}

/// A part of a block: of one that is a vtkPartitionedDataSet there are several, and so there are
/// with several ranks.
struct BlockPiece
{
  int port = 0; ///< the input's
  BlockPath path;
  vtkSmartPointer<vtkPolyData> data; ///< null: there is nothing, but a place in the tree
};

/// A block with what there is in it.
struct Block
{
  BlockPath path;
  vtkSmartPointer<vtkPolyData> data; ///< may be null
};

/// What a port takes.
enum class Taken
{
  Polygons, ///< vtkPolyData: its cells count
  Points    ///< any vtkDataSet: its points count
};

/// Appends the pieces of an input (plain, a vtkMultiBlockDataSet, a vtkPartitionedDataSet, a
/// vtkPartitionedDataSetCollection, or these in one another), without ghost cells. An error names
/// the block that cannot be taken. What distinguishes the input from one of before is appended to
/// `version`.
Status collectPieces(vtkDataObject* input, int port, Taken taken, std::vector<BlockPiece>& pieces,
  std::vector<unsigned long long>& version);

/// The blocks of a port, in the order of their paths. Pieces of one block become one surface,
/// without cracks where they meet (see joinPieces).
std::vector<Block> joinBlocks(const std::vector<BlockPiece>& pieces, int port);

/// All blocks as one. Where there are several, the cell array "BlockId" (int) counts them.
vtkSmartPointer<vtkPolyData> mergeBlocks(const std::vector<Block>& blocks);

/// The same array for pieces that are not joined: all ranks' blocks count. Where there are several,
/// pieces lose their global ids, which blocks may share.
void numberPieces(const std::vector<Block>& blocks, std::vector<BlockPiece>& pieces);

/// Fills a vtkMultiBlockDataSet or a vtkPartitionedDataSetCollection.
void fillTree(const std::vector<Block>& blocks, vtkDataObject* tree);
}

#endif
