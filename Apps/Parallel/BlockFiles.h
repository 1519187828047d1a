// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Surfaces in pieces, a file each, and meshes of blocks in files.
#ifndef stipple_BlockFiles_h
#define stipple_BlockFiles_h

#include "OutputFiles.h"
#include "RankMessages.h"
#include "SurfaceBlocks.h"

#include <string>
#include <vector>

class vtkPartitionedDataSet;

namespace stipple
{
/// What a program reads, and writes in pieces: ".pvtp", ".vtpd".
[[nodiscard]] const std::vector<std::string>& pieceFileExtensions();
[[nodiscard]] bool isPieceFile(const std::string& file);

/// The files of a surface: those that a .pvtp or .vtpd names, or the file itself. All ranks call
/// it, and the first looks.
[[nodiscard]] Status findPieces(
  const std::string& file, const RankMessages& ranks, std::vector<std::string>& pieces);

/// This rank's share of pieces, which are read from their files whenever they are asked for.
[[nodiscard]] SurfacePieces shareOfPieces(
  const std::vector<std::string>& pieces, const RankMessages& ranks);

/// Writes what all ranks have: pieces of their own and, by the first rank, the file that names
/// them, for .pvtp and .vtpd; and for a mesh file all in one, by the first rank, points in the
/// order of their global ids. Pieces may have so many rings of ghost cells, a mesh in one none.
/// Nothing is in place before files are committed.
[[nodiscard]] Status writeBlockFiles(vtkPartitionedDataSet* blocks, const std::string& file,
  int ghostLevels, const RankMessages& ranks, OutputFiles& files);
}

#endif
