# Recorded results become pages and plots, one page a renderer; what has become worse is told, and
# nothing else.
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")

# add_line(<name> <ms> <to_vtk> <wrong pixels> <memory> <counters>): three laps, whose times differ.
function (add_line name ms to_vtk wrong memory counters)
  set(text "${LINES}")
  foreach (lap IN ITEMS 0 1 2)
    if (NOT text STREQUAL "")
      string(APPEND text ",\n")
    endif ()
    string(APPEND text "    {\"name\": \"${name}\", \"run_name\": \"${name}\", "
      "\"run_type\": \"iteration\", \"repetition_index\": ${lap}, \"iterations\": 1, "
      "\"real_time\": ${ms}.${lap}, \"cpu_time\": 1.0, \"time_unit\": \"ms\", \"p95_ms\": ${ms}.9, "
      "\"cpu_ms\": 1.0, \"gpu_ms\": ${ms}.0, \"to_vtk\": ${to_vtk}${lap}, \"to_none\": 2.0${lap}, "
      "\"frames\": 20, ${counters}")
    if (NOT name MATCHES "technique:none")
      string(APPEND text ", \"gpu_ms:mask\": 0.5, \"pixels\": 10000, \"wrong_pixels\": ${wrong}, "
        "\"wrong_percent\": 1.${wrong}, \"wrongly_dark_percent\": 0.5, "
        "\"wrongly_lit_percent\": 0.5, \"far_percent\": 0.1, \"memory_bytes\": ${memory}000000")
    endif ()
    string(APPEND text "}")
  endforeach ()
  set(LINES "${text}" PARENT_SCOPE)
endfunction ()

# record(<file> <renderer> <to_vtk of rtw> <wrong pixels of rtw>)
function (record file RENDERER ratio wrong)
  set(LINES "")
  set(rest "\"lights\": 1, \"width\": 64, \"height\": 64")
  foreach (map IN ITEMS 512 1024)
    set(setup "maps/scene:town/map:${map}/technique:")
    set(counters "\"triangles\": 1000, \"actors\": 1, \"resolution\": ${map}, ${rest}")
    add_line("${setup}none" 10 0.5 0 0 "${counters}")
    add_line("${setup}vtk" 20 1.0 900 8 "${counters}")
    add_line("${setup}rtw" ${map} ${ratio} ${wrong} ${map} "${counters}")
  endforeach ()
  foreach (actors IN ITEMS 1 10 100)
    set(setup "actors/scene:town/actors:${actors}/map:1024/technique:")
    set(counters "\"triangles\": 1000, \"actors\": ${actors}, \"resolution\": 1024, ${rest}")
    add_line("${setup}none" 1${actors} 0.5 0 0 "${counters}")
    add_line("${setup}vtk" 2${actors} 1.0 900 8 "${counters}")
    add_line("${setup}rtw" 3${actors} ${ratio} ${wrong} 8 "${counters}")
  endforeach ()
  configure_file("${CMAKE_CURRENT_LIST_DIR}/Recorded.json.in" "${FOLDER}/${file}" @ONLY)
endfunction ()

set(software "llvmpipe (LLVM 15.0.6, 256 bits)")
record(first.json "${software}" 2.0 500)
record(same.json "${software}" 2.0 500)
record(slower.json "${software}" 2.6 500)
record(worse.json "${software}" 2.0 520)
record(better.json "${software}" 1.5 400)
record(nvidia.json "NVIDIA H200/PCIe/SSE2" 1.0 500)

# expect(<exit code> <text of the output> <argument>...)
function (expect expected text)
  execute_process(COMMAND "${REPORT}" ${ARGN} --out "${FOLDER}/report" --check
    WORKING_DIRECTORY "${FOLDER}"
    RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE error)
  if (NOT code STREQUAL "${expected}" OR NOT output MATCHES "${text}" OR NOT error STREQUAL "")
    message(FATAL_ERROR "${ARGN}: exit code ${code}, expected ${expected}\n${output}${error}")
  endif ()
endfunction ()

expect(0 "^$" first.json)
expect(0 "No line has become" first.json same.json)
expect(0 "No line has become" first.json better.json)
expect(3 "slower.*technique:rtw: 2\\.6.* instead of 2\\.0" first.json slower.json)
expect(3 "less accurate.*technique:rtw: 520 instead of 500" first.json worse.json)
expect(0 "No line has become" first.json nvidia.json same.json)
foreach (file IN ITEMS RESULTS.md RESULTS-llvmpipe.md RESULTS-nvidia-h200.md
    plots-llvmpipe/town.png plots-llvmpipe/growth-actors.png plots-nvidia-h200/town.png)
  if (NOT EXISTS "${FOLDER}/report/${file}")
    message(FATAL_ERROR "there is no ${file}")
  endif ()
endforeach ()
file(READ "${FOLDER}/report/RESULTS-llvmpipe.md" page)
if (page MATCHES "NVIDIA" OR NOT page MATCHES "Since first.json" OR NOT page MATCHES "exponent")
  message(FATAL_ERROR "an unexpected page:\n${page}")
endif ()
