# A warp that is one cell off and a bias that is too large are each noticed. That a slower frame is, TestReport.cmake shows with recorded
# times: those of a test are whatever else the machine does.
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")

function (measure name)
  execute_process(
    COMMAND "${BENCHMARK}" --family maps --scene robot --resolution 512 --technique rtw
      --size 192x192 --frames 4 --laps 2 --minutes 1 --benchmark_out "${FOLDER}/${name}.json"
      ${ARGN}
    RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE error)
  if (NOT code STREQUAL "0" OR NOT error STREQUAL "")
    message(FATAL_ERROR "exit code ${code}\n${output}${error}")
  endif ()
endfunction ()

# expect(<name> <exit code> <text>)
function (expect name expected text)
  execute_process(
    COMMAND "${REPORT}" "${FOLDER}/good.json" "${FOLDER}/${name}.json" --check
      --out "${FOLDER}/${name}"
    RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE error)
  message("${output}")
  if (NOT code STREQUAL "${expected}" OR NOT output MATCHES "${text}" OR NOT error STREQUAL "")
    message(FATAL_ERROR "${name}: exit code ${code}, expected ${expected}\n${error}")
  endif ()
endfunction ()

measure(good)
foreach (fault IN ITEMS warp bias)
  measure(${fault} --fault ${fault})
endforeach ()
expect(warp 3 "less accurate.*technique:rtw: [0-9]+ instead of [0-9]+ wrong pixels")
expect(bias 3 "less accurate.*technique:rtw: [0-9]+ instead of [0-9]+ wrong pixels")
