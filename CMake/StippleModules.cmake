# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
include(StippleAddModule)

# Finds the vtk.module files under Filters/ and Rendering/ and builds them as VTK modules (Stipple::*).
vtk_module_find_modules(stipple_module_files
  "${CMAKE_SOURCE_DIR}/Filters"
  "${CMAKE_SOURCE_DIR}/Rendering")
vtk_module_scan(
  MODULE_FILES ${stipple_module_files}
  PROVIDES_MODULES stipple_modules
  REQUIRES_MODULES stipple_required_modules
  WANT_BY_DEFAULT ON
  HIDE_MODULES_FROM_CACHE ON)
# Where the headers of modules with object factories find VTK's macros: as VTK's module system documents it.
set_property(GLOBAL PROPERTY _vtk_module_autoinit_include "${VTK_AUTOINIT_INCLUDE}")
set(stipple_cmake_destination "${CMAKE_INSTALL_LIBDIR}/cmake/Stipple")
vtk_module_build(
  MODULES ${stipple_modules}
  PACKAGE Stipple
  INSTALL_EXPORT Stipple
  INSTALL_HEADERS ON
  CMAKE_DESTINATION "${stipple_cmake_destination}"
  HEADERS_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/stipple"
  TARGETS_COMPONENT libraries
  ENABLE_WRAPPING ${STIPPLE_WRAP_PYTHON}
  VERSION "${PROJECT_VERSION}"
  SOVERSION "${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}"
  TEST_DIRECTORY_NAME "NONE")
