# cmake -DPROGRAM=<shadow-compare> -DFOLDER=<for files> -P TestRun.cmake
# A small comparison gives a table, all its pictures, and numbers that hang together.
file(REMOVE_RECURSE "${FOLDER}")
execute_process(
  COMMAND "${PROGRAM}" robot --resolution 128 --size 160x120 --frames 1
    --pieces 3 --out "${FOLDER}/pictures" --debug-view shadow,aliasing,importance,grid,layers --json "${FOLDER}/pictures/numbers.json"
  RESULT_VARIABLE code OUTPUT_VARIABLE table ERROR_VARIABLE error)
string(REGEX REPLACE "[a-z ]+: [0-9]+ %\n" "" error "${error}") # a busy machine's progress
if (NOT code STREQUAL "0" OR NOT error STREQUAL "")
  message(FATAL_ERROR "exit code ${code}, stderr: ${error}")
endif ()
if (NOT table MATCHES "robot: 14772 triangles, 160 x 120 pixels" OR NOT table MATCHES "\nvtk +128 ")
  message(FATAL_ERROR "an unexpected table:\n${table}")
endif ()
foreach (name IN ITEMS none truth vtk-128 vtk-128-mask vtk-128-difference uniform-128 rtw-128
    uniform-128-shadow uniform-128-aliasing uniform-128-importance uniform-128-grid uniform-128-layers
    rtw-128-aliasing)
  if (NOT EXISTS "${FOLDER}/pictures/robot-${name}.png")
    message(FATAL_ERROR "there is no picture robot-${name}.png")
  endif ()
endforeach ()
# A file of the same bytes would be of a view that is none.
file(GLOB pictures "${FOLDER}/pictures/robot-rtw-128*.png")
set(sums)
foreach (picture IN LISTS pictures)
  file(MD5 "${picture}" sum)
  list(APPEND sums "${sum}")
endforeach ()
list(REMOVE_DUPLICATES sums)
list(LENGTH sums count)
if (NOT count EQUAL 8 OR EXISTS "${FOLDER}/pictures/robot-vtk-128-grid.png")
  message(FATAL_ERROR "the pictures are ${pictures}")
endif ()
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
