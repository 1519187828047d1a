# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
# The libraries that Stipple stands on. VTK's components are named one by one: all of VTK would drag in Qt.
if (STIPPLE_WRAP_PYTHON AND NOT Python3_EXECUTABLE)
  # The interpreter that has vtkmodules is the system's, also where another python3 comes first in PATH.
  find_program(STIPPLE_SYSTEM_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH)
  mark_as_advanced(STIPPLE_SYSTEM_PYTHON)
  if (STIPPLE_SYSTEM_PYTHON)
    set(Python3_EXECUTABLE "${STIPPLE_SYSTEM_PYTHON}" CACHE FILEPATH "Python interpreter that has vtkmodules")
  endif ()
endif ()
find_package(VTK 9.1 REQUIRED COMPONENTS
  CommonColor CommonComputationalGeometry CommonCore CommonDataModel CommonExecutionModel CommonMath
  CommonMisc CommonSystem CommonTransforms
  FiltersCore FiltersExtraction FiltersGeneral FiltersGeometry FiltersModeling FiltersSources FiltersTexture
  ImagingCore ImagingGeneral ImagingHybrid
  InteractionStyle InteractionWidgets
  IOGeometry IOImage IOLegacy IOParallelXML IOPLY IOXML IOXMLParser
  ParallelCore
  RenderingAnnotation RenderingContext2D RenderingContextOpenGL2 RenderingCore RenderingFreeType RenderingOpenGL2 RenderingUI
  ChartsCore ViewsContext2D
  TestingCore TestingRendering
  jsoncpp utf8
  OPTIONAL_COMPONENTS ParallelMPI WrappingPythonCore Python PythonInterpreter)
# VTK calls OpenGL through glad from 9.4 on, through GLEW before (Rendering/Headless/StippleOpenGL.h).
set(stipple_opengl_targets VTK::glew VTK::opengl)
if (TARGET VTK::glad)
  set(stipple_opengl_targets VTK::glad)
endif ()
include(StippleLibraries)
