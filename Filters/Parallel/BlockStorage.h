// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Blocks in files, and data sets as bytes.
#ifndef stipple_BlockStorage_h
#define stipple_BlockStorage_h

#include "SurfaceBlocks.h"

#include <iosfwd>
#include <memory>

namespace stipple
{
/// A data set as bytes, and back.
STIPPLEFILTERSPARALLEL_EXPORT Bytes pack(vtkPolyData* data);
STIPPLEFILTERSPARALLEL_EXPORT vtkSmartPointer<vtkPolyData> unpack(const Bytes& bytes);

/// Their number, and they. Reading throws if they are not there.
void writeBytes(std::ofstream& file, const Bytes& bytes);
Bytes readBytes(std::ifstream& file);

/// A block in memory for as long as this lives, if it is kept in a file else. What changed is
/// written only if that is asked for.
class STIPPLEFILTERSPARALLEL_EXPORT BlockInMemory
{
public:
  explicit BlockInMemory(const SurfaceBlock& block);
  ~BlockInMemory();
  BlockInMemory(const BlockInMemory&) = delete;
  BlockInMemory& operator=(const BlockInMemory&) = delete;
  const SurfaceBlock* operator->() const { return this->Block; }
  const SurfaceBlock& operator*() const { return *this->Block; }

private:
  const SurfaceBlock* Block;
  std::unique_ptr<SurfaceBlock> Read;
};

/// Puts a block into its file, if it has one, and keeps its numbers alone.
STIPPLEFILTERSPARALLEL_EXPORT void park(SurfaceBlock& block);
}

#endif
