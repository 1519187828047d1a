// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What VTK's readers take on trust, looked at before they do: counts in headers that a file is too
// short for, cells that name points which do not exist, lines without the numbers they should have.
// VTK 9.1 allocates by such counts, and reads and writes beyond its arrays.
#ifndef stipple_FileCheck_h
#define stipple_FileCheck_h

#include "Progress.h"

#include <string>

namespace stipple
{
/// Of a file with this extension (".obj", ".stl", ".vtk", ".vtp"; any other one is fine). An error
/// says what is wrong, and where.
[[nodiscard]] Status checkFile(const std::string& file, const std::string& extension);
}

#endif
