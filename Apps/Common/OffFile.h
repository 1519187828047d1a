// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Geomview's object file format, which VTK 9.1 does not read.
#ifndef stipple_OffFile_h
#define stipple_OffFile_h

#include "Progress.h"

#include <string>

class vtkPolyData;

namespace stipple
{
/// Text only. Prefixes (COFF, NOFF, STOFF, ...), comments, a missing edge count, colours and
/// normals behind the coordinates, and polygons of any size are understood; colours, normals and
/// texture are left out.
[[nodiscard]] Status readOff(const std::string& file, vtkPolyData* mesh);

[[nodiscard]] bool writeOff(vtkPolyData* mesh, const std::string& file);
}

#endif
