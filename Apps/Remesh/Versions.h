// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef stipple_Versions_h
#define stipple_Versions_h

#include <string>

namespace stipple
{
/// What --version prints: Stipple, VTK, CGAL, and what OpenGL calls itself (which makes a context).
[[nodiscard]] std::string versionText();
}

#endif
