# Chooses the Python whose vtkmodules are those of the VTK found, unless Python3_EXECUTABLE names
# one. The first python3 on the PATH is often another (pyenv, conda, a virtual environment), and
# a package built for it would not import.
find_package(VTK 9.1 QUIET COMPONENTS CommonCore)

if (VTK_FOUND AND NOT DEFINED Python3_EXECUTABLE)
  set(_rtw_pythons)
  foreach (_rtw_name IN ITEMS python3 python3.14 python3.13 python3.12 python3.11 python3.10
      python3.9)
    find_program(_rtw_found NAMES ${_rtw_name} NO_CACHE)
    list(APPEND _rtw_pythons ${_rtw_found})
    unset(_rtw_found)
  endforeach ()
  list(APPEND _rtw_pythons /usr/bin/python3 /usr/local/bin/python3)
  list(REMOVE_DUPLICATES _rtw_pythons)

  foreach (_rtw_python IN LISTS _rtw_pythons)
    if (NOT EXISTS "${_rtw_python}")
      continue ()
    endif ()
    execute_process(
      COMMAND "${_rtw_python}" -c
        "from vtkmodules.vtkCommonCore import vtkVersion as v; print(v.GetVTKVersion(), end='')"
      RESULT_VARIABLE _rtw_result
      OUTPUT_VARIABLE _rtw_version
      ERROR_QUIET)
    if (_rtw_result EQUAL 0 AND _rtw_version VERSION_EQUAL VTK_VERSION)
      set(Python3_EXECUTABLE "${_rtw_python}" CACHE FILEPATH "The Python of VTK's own wrapping")
      message(STATUS "Python with VTK ${VTK_VERSION}: ${_rtw_python}")
      break ()
    endif ()
  endforeach ()

  if (NOT DEFINED Python3_EXECUTABLE)
    message(WARNING
      "RTW_WRAP_PYTHON is ON, but no python3 found here imports vtkmodules ${VTK_VERSION}. "
      "Install VTK's Python package (Debian: python3-vtk9), or name the interpreter by "
      "-DPython3_EXECUTABLE=..., or turn RTW_WRAP_PYTHON off.")
  endif ()
endif ()
set(Python3_FIND_STRATEGY LOCATION)
