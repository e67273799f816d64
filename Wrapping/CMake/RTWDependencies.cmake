# Everything that is looked for outside the tree.

# VTK. The components are always named: without, Debian's package wants Qt and a lot more.
set(rtw_vtk_components
  CommonCore CommonDataModel CommonExecutionModel CommonMath CommonTransforms
  FiltersCore RenderingCore RenderingOpenGL2)
# VTK <= 9.3 loads OpenGL by GLEW and needs `opengl` to link; VTK >= 9.4 has glad, alone.
# RenderingLOD has an actor whose levels of detail have to be known.
set(rtw_vtk_optional_components RenderingLOD glew glad opengl)

# For tests and examples; a build without them asks VTK for no more than the module does.
set(rtw_vtk_test_components)
if (BUILD_TESTING OR RTW_BUILD_EXAMPLES)
  set(rtw_vtk_test_components
    CommonSystem FiltersGeneral FiltersGeometry FiltersModeling FiltersSources IOCore
    IOGeometry IOImage IOPLY IOXML ImagingCore InteractionStyle RenderingAnnotation
    RenderingFreeType RenderingLOD RenderingUI RenderingVolume RenderingVolumeOpenGL2 jsoncpp vtksys)
  # The command lines of examples and benchmarks.
  find_package(CLI11 QUIET)
endif ()

set(_rtw_python_components)
if (RTW_WRAP_PYTHON)
  include(RTWFindPython)
  set(_rtw_python_components Python WrappingPythonCore)
endif ()

find_package(VTK 9.1 REQUIRED
  COMPONENTS ${rtw_vtk_components} ${_rtw_python_components}
  OPTIONAL_COMPONENTS ${rtw_vtk_optional_components} ${rtw_vtk_test_components})

find_package(glm REQUIRED)

# Headless rendering is by EGL. Where there is none (Windows, macOS) the window class is still
# there and says so when used.
find_package(OpenGL QUIET COMPONENTS EGL)
if (TARGET OpenGL::EGL)
  set(RTW_HAVE_EGL 1)
else ()
  set(RTW_HAVE_EGL 0)
  message(STATUS "EGL not found: vtkRTWEGLRenderWindow cannot render")
endif ()
