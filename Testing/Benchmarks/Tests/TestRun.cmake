# A small run gives lines with all counters, VTK's own pass among them, and a report; another gives
# exactly as many wrong pixels.
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")
foreach (run IN ITEMS first second)
  execute_process(
    COMMAND "${BENCHMARK}" --family maps --scene robot --resolution 64,128 --size 96x64 --frames 2
      --benchmark_out "${FOLDER}/${run}.json"
    RESULT_VARIABLE code OUTPUT_VARIABLE table ERROR_VARIABLE error)
  if (NOT code STREQUAL "0" OR NOT error STREQUAL "" OR NOT table MATCHES "\n  rtw ")
    message(FATAL_ERROR "exit code ${code}\n${table}\n${error}")
  endif ()
endforeach ()

file(READ "${FOLDER}/first.json" json)
foreach (text IN ITEMS gl_renderer gl_version vtk_version build_type num_cpus real_time cpu_time
    p95_ms cpu_ms gpu_ms gpu_ms:mask to_vtk to_none frames pixels wrong_pixels wrong_percent
    wrongly_dark_percent wrongly_lit_percent far_percent near_percent undecided_percent
    memory_bytes triangles actors lights width height resolution)
  if (NOT json MATCHES "\"${text}\": ")
    message(FATAL_ERROR "no \"${text}\" in ${FOLDER}/first.json")
  endif ()
endforeach ()
foreach (technique IN ITEMS none vtk vtk-kept uniform rtw)
  if (NOT json MATCHES "maps/scene:robot/map:64/technique:${technique}\"")
    message(FATAL_ERROR "no line of ${technique} in ${FOLDER}/first.json")
  endif ()
endforeach ()

execute_process(
  COMMAND "${REPORT}" "${FOLDER}/first.json" "${FOLDER}/second.json" --out "${FOLDER}/report"
  RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE error)
if (NOT code STREQUAL "0" OR NOT error STREQUAL ""
    OR NOT output MATCHES "Wrong pixels are exactly as many in 8 of 8")
  message(FATAL_ERROR "exit code ${code}\n${output}\n${error}")
endif ()

# One frame is one place, also for pixels; one lap has nothing to flicker.
execute_process(
  COMMAND "${BENCHMARK}" --family maps --scene robot --resolution 64 --size 96x64 --frames 1 --laps 1
    --technique rtw --benchmark_out "${FOLDER}/one.json"
  RESULT_VARIABLE code OUTPUT_VARIABLE table ERROR_VARIABLE error)
file(READ "${FOLDER}/one.json" one)
string(REGEX MATCHALL "\"pixels\": [0-9.e+]+" all "${json}")
string(REGEX MATCHALL "\"pixels\": [0-9.e+]+" few "${one}")
list(GET all 0 all)
list(GET few 0 few)
if (NOT code STREQUAL "0" OR NOT error STREQUAL "" OR NOT one MATCHES "\"frames\": 1\\.0*e[+]00"
    OR one MATCHES "\"frames\": [2-9]" OR few STREQUAL all)
  message(FATAL_ERROR "exit code ${code}: more than one place\n${table}\n${error}${few}, ${all}")
endif ()
