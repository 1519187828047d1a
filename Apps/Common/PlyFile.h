// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The polygon file format. VTK 9.1's reader crashes on files that end too early, and both its
// reader and its writer round coordinates to float.
#ifndef stipple_PlyFile_h
#define stipple_PlyFile_h

#include "Progress.h"

#include <string>

class vtkPolyData;

namespace stipple
{
/// Text and binary of either byte order. Vertices' and faces' other numbers become arrays of their
/// names; other elements and other lists are passed over.
[[nodiscard]] Status readPly(const std::string& file, vtkPolyData* mesh);

/// Binary, coordinates as doubles, no arrays but the labels of regions (see RegionFile.h). Faces
/// have at most 255 corners.
[[nodiscard]] Status writePly(vtkPolyData* mesh, const std::string& file);
}

#endif
