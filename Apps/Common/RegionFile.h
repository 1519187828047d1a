// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Regions in files: the groups and materials of Wavefront's OBJ, and the solids of STL. In a mesh
// they are cell arrays of ids and field arrays of names (see RegionArrays.h): GroupIds and
// GroupNames, MaterialIds and MaterialNames, SolidIds and SolidNames.
#ifndef stipple_RegionFile_h
#define stipple_RegionFile_h

#include "Progress.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace stipple
{
/// Adds the groups (`g`, or `o` where there are none) and materials (`usemtl`) that a file's
/// content has to the mesh that was read from it. What stands before the first of them is called
/// "default". Lines, whose cells come first, have the first.
void addObjRegions(const std::string& content, vtkPolyData* mesh);

/// Likewise the solids of a text file of more than one; mesh has VTK's labels of solids.
void addStlSolids(const std::string& file, vtkPolyData* mesh);

/// The regions that a mesh keeps apart (see vtkConformalAtlas::RegionArrayName).
class MeshRegions
{
public:
  explicit MeshRegions(vtkPolyData* mesh);

  bool empty() const { return this->Names.empty(); }
  const std::string& array() const { return this->Array; }
  /// By number, in the labels' order; the labels where they have no names.
  const std::vector<std::string>& names() const { return this->Names; }
  /// The cells of every region.
  const std::vector<std::vector<int>>& cells() const { return this->Cells; }

private:
  std::string Array;
  std::vector<std::string> Names;
  std::vector<std::vector<int>> Cells;
};

/// The line that begins a region in an OBJ file, and the file that says what its materials are;
/// empty if regions are no materials.
[[nodiscard]] std::string objRegionLine(const MeshRegions& regions, std::size_t number);
[[nodiscard]] std::string objMaterialLibrary(vtkPolyData* mesh, const MeshRegions& regions);

/// Writes a text file with a solid a region.
[[nodiscard]] bool writeStlSolids(
  vtkPolyData* mesh, const MeshRegions& regions, const std::string& file);
}

#endif
