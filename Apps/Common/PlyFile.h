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
/// names; vertices' s and t, u and v, texture_s and texture_t, texture_u and texture_v, or faces'
/// lists texcoord, also the texture coordinates of points, which then are there once for each pair.
/// Other elements and other lists are passed over.
[[nodiscard]] Status readPly(const std::string& file, vtkPolyData* mesh);

/// Binary, coordinates as doubles, no arrays but the labels of regions (see RegionFile.h) and, as
/// faces' lists texcoord of single precision, the texture coordinates of corners (see
/// CornerTexture.h). Faces have at most 255 corners.
[[nodiscard]] bool writePly(vtkPolyData* mesh, const std::string& file);
}

#endif
