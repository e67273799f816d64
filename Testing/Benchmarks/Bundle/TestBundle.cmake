# cmake -DBUILD=<build> -DCONFIG=<type> -DARCHIVE=<file> -DFOLDER=<for files> -P TestBundle.cmake
# The archive, unpacked elsewhere and run with an empty environment, measures and reports; all its
# libraries but the machine's come from itself.
execute_process(
  COMMAND "${CMAKE_COMMAND}" --build "${BUILD}" --config "${CONFIG}" --target benchmark-bundle
  RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
if (NOT code EQUAL 0)
  message(FATAL_ERROR "benchmark-bundle cannot be built:\n${output}")
endif ()
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")
execute_process(COMMAND "${CMAKE_COMMAND}" -E tar xf "${ARCHIVE}" WORKING_DIRECTORY "${FOLDER}")
set(top "${FOLDER}/shadow-benchmark")

function (run_clean)
  execute_process(COMMAND env -i PATH=/usr/bin:/bin HOME=/nonexistent ${ARGN}
    WORKING_DIRECTORY "${top}"
    RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE error)
  if (NOT code EQUAL 0)
    message(FATAL_ERROR "${ARGN}: exit code ${code}\n${output}${error}")
  endif ()
  set(output "${output}" PARENT_SCOPE)
endfunction ()

run_clean("LD_LIBRARY_PATH=${top}/lib:${top}/lib-x" ldd bin/shadow-benchmark)
string(REPLACE "\n" ";" lines "${output}")
foreach (line IN LISTS lines)
  if (line MATCHES "not found" OR (line MATCHES "lib(vtk|embree|benchmark|stdc|gcc_s|GLEW)"
      AND NOT line MATCHES "${top}/lib"))
    message(FATAL_ERROR "shadow-benchmark needs what is not in the archive:${line}")
  endif ()
endforeach ()

run_clean(./run --quick --family maps --scene robot --resolution 64 --size 64x64 --frames 1
  --error-views 1)
foreach (file IN ITEMS results.json RESULTS.md)
  if (NOT EXISTS "${top}/${file}")
    message(FATAL_ERROR "there is no ${file}:\n${output}")
  endif ()
endforeach ()
