# cmake -DBUILD=<build> -DCONFIG=<type> -DSTAGE=<folder> -DARCHIVE=<file.tar.xz> -P Bundle.cmake
# Packs the installed component "benchmark" with all libraries that it needs, but for those that
# belong to a machine: its C library, and its OpenGL driver.
set(top "${STAGE}/shadow-benchmark")
file(REMOVE_RECURSE "${STAGE}")
execute_process(
  COMMAND "${CMAKE_COMMAND}" --install "${BUILD}" --config "${CONFIG}" --component benchmark
    --prefix "${top}" --strip
  RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
if (NOT code EQUAL 0)
  message(FATAL_ERROR "The programs cannot be installed:\n${output}")
endif ()

set(of_the_machine
  "^ld-linux" "^libc\\.so" "^libm\\.so" "^libdl\\.so" "^libpthread\\.so" "^librt\\.so"
  "^libutil\\.so" "^libresolv\\.so" "^libnsl\\.so" "^libmvec\\.so" "^libBrokenLocale\\.so"
  "^libGL\\.so" "^libGLX" "^libEGL" "^libOpenGL" "^libGLdispatch" "^libGLES" "^libglapi" "^libgbm"
  "^libdrm" "^libnvidia")
# Not drivers, but what programs for X need of it: only where the machine has none of its own.
set(of_x "^lib(X|xcb|SM|ICE|bsd|md\\.so)")
file(GLOB programs "${top}/bin/*")
file(GET_RUNTIME_DEPENDENCIES
  EXECUTABLES ${programs}
  DIRECTORIES "${BUILD}/lib"
  PRE_EXCLUDE_REGEXES ${of_the_machine}
  RESOLVED_DEPENDENCIES_VAR libraries
  UNRESOLVED_DEPENDENCIES_VAR missing)
if (missing)
  message(FATAL_ERROR "Libraries are not found: ${missing}")
endif ()
foreach (library IN LISTS libraries)
  get_filename_component(name "${library}" NAME)
  if (name MATCHES "${of_x}")
    set(folder "${top}/lib-x")
  else ()
    set(folder "${top}/lib")
  endif ()
  file(INSTALL "${library}" DESTINATION "${folder}" FOLLOW_SYMLINK_CHAIN)
endforeach ()

find_program(strip_program strip)
file(GLOB files LIST_DIRECTORIES false "${top}/lib/*" "${top}/lib-x/*")
if (strip_program)
  execute_process(COMMAND "${strip_program}" --strip-unneeded ${files} ERROR_QUIET)
endif ()
file(INSTALL "${CMAKE_CURRENT_LIST_DIR}/run" "${CMAKE_CURRENT_LIST_DIR}/README.md"
  DESTINATION "${top}" USE_SOURCE_PERMISSIONS)

execute_process(COMMAND "${CMAKE_COMMAND}" -E tar cJf "${ARCHIVE}" shadow-benchmark
  WORKING_DIRECTORY "${STAGE}" RESULT_VARIABLE code)
if (NOT code EQUAL 0)
  message(FATAL_ERROR "${ARCHIVE} cannot be written")
endif ()
file(SIZE "${ARCHIVE}" size)
math(EXPR mebibytes "${size} / 1048576")
if (mebibytes GREATER_EQUAL 60)
  message(FATAL_ERROR "${ARCHIVE} has ${mebibytes} MiB; less than 60 are wanted")
endif ()
message(STATUS "${ARCHIVE}: ${mebibytes} MiB")
