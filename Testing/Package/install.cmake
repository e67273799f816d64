# Installs BUILD, with its headers in HEADERS, and moves the result to PREFIX, since a package must work wherever it lies.
file(REMOVE_RECURSE "${PREFIX}" "${PREFIX}.staging")
set(_config)
if (CONFIG)
  set(_config --config "${CONFIG}")
endif ()
execute_process(
  COMMAND "${CMAKE_COMMAND}" --install "${BUILD}" ${_config} --prefix "${PREFIX}.staging"
  RESULT_VARIABLE _result)
if (NOT _result EQUAL 0)
  message(FATAL_ERROR "installing failed: ${_result}")
endif ()
file(RENAME "${PREFIX}.staging" "${PREFIX}")

# Only public headers are installed, and none may need a private one.
file(GLOB _headers "${PREFIX}/${HEADERS}/*.h")
foreach (_header IN LISTS _headers)
  file(STRINGS "${_header}" _includes REGEX "^#include \"rtw")
  if (_includes OR _header MATCHES "/rtw[^/]*$")
    message(FATAL_ERROR "${_header} is private, or needs a private header: ${_includes}")
  endif ()
endforeach ()
