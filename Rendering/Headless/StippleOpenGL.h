// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// OpenGL's functions as VTK has them: by glad from VTK 9.4 on, by GLEW before. To be included
// first.
#ifndef stipple_StippleOpenGL_h
#define stipple_StippleOpenGL_h

#if __has_include("vtk_glad.h")
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

#endif
