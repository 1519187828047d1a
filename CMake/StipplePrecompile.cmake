# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
# stipple_precompile(TARGET HEADER...): what nearly every source of the target includes is compiled once, which halves
# the time of a test's source, and takes a third from others'; in targets of few sources it would take more than it saves. Sources include what they use all
# the same: clang-tidy, and builds with CMAKE_DISABLE_PRECOMPILE_HEADERS, have nothing else.
function (stipple_precompile target)
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "\\.cxx$")
  list(LENGTH sources number)
  if (number LESS 8)
    return ()
  endif ()
  target_precompile_headers(${target} PRIVATE
    <algorithm> <array> <cmath> <functional> <limits> <map> <memory> <numeric> <set> <string> <unordered_map> <utility>
    <vector>
    <Eigen/Core> <Eigen/Geometry>
    <vtkCellData.h> <vtkNew.h> <vtkPartitionedDataSetCollection.h> <vtkPointData.h> <vtkPolyData.h> <vtkSmartPointer.h>
    ${ARGN})
endfunction ()
