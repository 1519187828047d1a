# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
# libStippleOSMesa, and stipple_link_osmesa(target), which makes a program able to draw with OSMesa
# (vtkHeadlessRenderWindow says when one wants that). Where there is no OSMesa (Mesa 25.1 dropped it), the
# function does nothing, and the program draws through EGL.
find_library(STIPPLE_OSMESA_LIBRARY OSMesa)
mark_as_advanced(STIPPLE_OSMESA_LIBRARY)
if (STIPPLE_OSMESA_LIBRARY)
  add_library(StippleOSMesa SHARED "${CMAKE_SOURCE_DIR}/Rendering/Headless/OSMesaFirst/StippleOSMesa.c")
  target_link_libraries(StippleOSMesa PRIVATE "${STIPPLE_OSMESA_LIBRARY}")
  set_target_properties(StippleOSMesa PROPERTIES
    VERSION "${PROJECT_VERSION}"
    SOVERSION "${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}")
  install(TARGETS StippleOSMesa
    LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT libraries NAMELINK_COMPONENT development)
endif ()

function (stipple_link_osmesa target)
  if (TARGET StippleOSMesa)
    # First on the command line and never dropped, though the program calls nothing of it. OSMesa comes right
    # behind, not just as a dependency of a dependency, in case the program links libGL itself.
    add_dependencies(${target} StippleOSMesa)
    target_link_options(${target} BEFORE PRIVATE
      "LINKER:--no-as-needed" "$<TARGET_FILE:StippleOSMesa>" "${STIPPLE_OSMESA_LIBRARY}" "LINKER:--as-needed")
  endif ()
endfunction ()
