# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
# What find_package(Stipple COMPONENTS ...) reads, in the build tree and in the install tree alike.
include(CMakePackageConfigHelpers)

# The components are the modules without their "Stipple::"; VTK is asked for by the components they use.
string(REPLACE "Stipple::" "" stipple_components "${stipple_modules}")
set(stipple_vtk_components ${stipple_required_modules})
list(FILTER stipple_vtk_components INCLUDE REGEX "^VTK::")
string(REPLACE "VTK::" "" stipple_vtk_components "${stipple_vtk_components}")
list(REMOVE_DUPLICATES stipple_vtk_components)

vtk_module_export_find_packages(
  CMAKE_DESTINATION "${stipple_cmake_destination}"
  FILE_NAME "Stipple-vtk-module-find-packages.cmake"
  MODULES ${stipple_modules})
configure_package_config_file(
  "${CMAKE_CURRENT_LIST_DIR}/StippleConfig.cmake.in"
  "${CMAKE_BINARY_DIR}/${stipple_cmake_destination}/StippleConfig.cmake"
  INSTALL_DESTINATION "${stipple_cmake_destination}"
  NO_SET_AND_CHECK_MACRO)
# Before 1.0 a new minor version may change the interface.
write_basic_package_version_file(
  "${CMAKE_BINARY_DIR}/${stipple_cmake_destination}/StippleConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(
  FILES
    "${CMAKE_BINARY_DIR}/${stipple_cmake_destination}/StippleConfig.cmake"
    "${CMAKE_BINARY_DIR}/${stipple_cmake_destination}/StippleConfigVersion.cmake"
  DESTINATION "${stipple_cmake_destination}"
  COMPONENT development)
install(
  FILES "${CMAKE_SOURCE_DIR}/LICENSE"
  DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/licenses/Stipple"
  COMPONENT libraries)
