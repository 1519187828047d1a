# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
include(StipplePrecompile)

# stipple_add_module(MODULE CLASSES vtkX... KERNELS X... HEADERS X...): a VTK module of vtkX.{h,cxx} and, as plain
# C++17 beside them, of X.{h,cxx} and X.h, which are private to the project: not installed, but seen by its other
# targets.
function (stipple_add_module module)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "CLASSES;KERNELS;HEADERS")
  set(sources ${arg_KERNELS})
  list(TRANSFORM sources APPEND ".cxx")
  set(headers ${arg_KERNELS} ${arg_HEADERS})
  list(TRANSFORM headers APPEND ".h")
  vtk_module_add_module("${module}"
    CLASSES ${arg_CLASSES}
    SOURCES ${sources}
    PRIVATE_HEADERS ${headers})
  vtk_module_include("${module}"
    PUBLIC "$<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}>")
  get_target_property(target "${module}" ALIASED_TARGET)
  stipple_precompile("${target}")
endfunction ()
