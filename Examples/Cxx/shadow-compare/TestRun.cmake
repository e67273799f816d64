# cmake -DPROGRAM=<shadow-compare> -DFOLDER=<for files> -P TestRun.cmake
# A small comparison gives a table, all its pictures, and numbers that hang together.
file(REMOVE_RECURSE "${FOLDER}")
execute_process(
  COMMAND "${PROGRAM}" robot --resolution 128 --size 160x120 --frames 1
    --pieces 3 --out "${FOLDER}/pictures" --json "${FOLDER}/pictures/numbers.json"
  RESULT_VARIABLE code OUTPUT_VARIABLE table ERROR_VARIABLE error)
if (NOT code STREQUAL "0" OR NOT error STREQUAL "")
  message(FATAL_ERROR "exit code ${code}, stderr: ${error}")
endif ()
if (NOT table MATCHES "robot: 14772 triangles, 160 x 120 pixels" OR NOT table MATCHES "\nvtk +128 ")
  message(FATAL_ERROR "an unexpected table:\n${table}")
endif ()
foreach (name IN ITEMS none truth vtk-128 vtk-128-mask vtk-128-difference uniform-128 rtw-128)
  if (NOT EXISTS "${FOLDER}/pictures/robot-${name}.png")
    message(FATAL_ERROR "there is no picture robot-${name}.png")
  endif ()
endforeach ()
file(READ "${FOLDER}/pictures/numbers.json" json)
foreach (name IN ITEMS width height triangles lit_facing_pixels)
  if (NOT json MATCHES "\"${name}\" : [1-9]")
    message(FATAL_ERROR "no ${name} in:\n${json}")
  endif ()
endforeach ()
string(REGEX MATCHALL "\"technique\" : \"[a-z]+\"" results "${json}")
list(LENGTH results count)
if (NOT count EQUAL 3)
  message(FATAL_ERROR "${count} results instead of 3 in:\n${json}")
endif ()

execute_process(COMMAND "${PROGRAM}" --help
  RESULT_VARIABLE code OUTPUT_VARIABLE help ERROR_VARIABLE error)
if (NOT code STREQUAL "0" OR NOT help MATCHES "--depth-test")
  message(FATAL_ERROR "--help: exit code ${code}, ${help}${error}")
endif ()
