// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Meshes in files, by extension.
#ifndef stipple_MeshFile_h
#define stipple_MeshFile_h

#include "Progress.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace stipple
{
/// ".ply", ".obj", ".stl", ".off", ".vtp", ".vtk".
[[nodiscard]] const std::vector<std::string>& meshFileExtensions();

/// In lower case with its dot; empty if there is none.
[[nodiscard]] std::string fileExtension(const std::string& file);

/// Reads a surface and checks what no filter could repair: unreadable, empty, no faces, a
/// coordinate that is not finite, a face that names a point which does not exist.
[[nodiscard]] Status readMesh(const std::string& file, vtkSmartPointer<vtkPolyData>& mesh);

/// Likewise the polylines of a file: .vtp, .vtk or .obj.
[[nodiscard]] Status readCurves(const std::string& file, vtkSmartPointer<vtkPolyData>& curves);

/// Writes binary where the format has it, in full precision where the format has it (all but STL).
/// .vtp and .vtk keep all arrays; .obj (groups or materials), .stl (solids, as text) and .ply (a
/// property of faces) the regions of vtkConformalAtlas::RegionArrayName; .obj and .ply the texture
/// coordinates of corners. `target`: the name that the file will have, by which sentences call it
/// and whose extension says the format; empty: the file's own.
[[nodiscard]] Status writeMesh(
  vtkPolyData* mesh, const std::string& file, const std::string& target = {});

/// Likewise what vtkGeometryRemesher made: the texture coordinates of corners, which .obj and .ply
/// have beside one point a place, become those of points in .vtp and .vtk (vtkTextureSeamSplitter).
[[nodiscard]] Status writeRemesh(
  vtkPolyData* mesh, const std::string& file, const std::string& target = {});

/// Whether files with that ending have a place for labels of regions, and for texture coordinates.
[[nodiscard]] bool keepsRegions(const std::string& extension);
[[nodiscard]] bool keepsTexture(const std::string& extension);
}

#endif
