// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What the ranks of a parallel ParaView tell one another. Each call is made by all ranks; with one
// rank it does nothing.
#ifndef stipple_RankExchange_h
#define stipple_RankExchange_h

#include "BlockTree.h"

#include <functional>
#include <string>
#include <vector>

class vtkInformationVector;
class vtkMultiProcessController;
class vtkPartitionedDataSetCollection;

namespace stipple
{
class RankExchange
{
public:
  /// Of the process: VTK's global controller, if there is one.
  RankExchange();

  /// Whether this rank is the one that computes.
  bool isRoot() const;

  /// Makes both the same on all ranks: `any` true if it is on one, and `sentence` that of the first
  /// rank that has one.
  void agree(bool& any, std::string& sentence) const;

  /// Moves all pieces to the root, in the order of the ranks; the others have none afterwards.
  void gather(std::vector<BlockPiece>& pieces) const;

  /// The root's words and blocks (their paths alone) to all.
  void share(std::vector<std::string>& words) const;
  void share(std::vector<Block>& blocks) const;
  /// The members of the root's collection, by their names, without data, to all: ParaView's views
  /// wait forever for ranks whose trees differ. Null is none.
  void share(vtkPartitionedDataSetCollection* collection) const;

private:
  vtkMultiProcessController* Controller = nullptr; ///< null with one rank
};

/// What RequestData() of a filter behind others of these does: work() on the root, which answers
/// whether it went well. The other ranks have outputs of the same structure, without data. Answers
/// 1: who failed has said so, has empty outputs, and need not be tried again with every frame.
int runOnRoot(vtkInformationVector* output, const std::function<int()>& work);
}

#endif
