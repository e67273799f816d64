# cmake -DPROGRAM=<shadow-storage> -P TestRun.cmake
# A table of numbers that can be told by hand, every figure, and what cannot be obeyed.
set(failures 0)

function (expect text)
  execute_process(COMMAND "${PROGRAM}" ${ARGN}
    RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE error)
  string(FIND "${output}" "${text}" found)
  if (NOT code STREQUAL "0" OR found EQUAL -1 OR output MATCHES "nan|inf,[^,]*,[^,]*,[^,]*inf")
    message("shadow-storage ${ARGN}\n  exit code ${code}\n${output}${error}  expected: ${text}")
    math(EXPR failures "${failures} + 1")
    set(failures ${failures} PARENT_SCOPE)
  endif ()
endfunction ()

function (expect_refusal text)
  execute_process(COMMAND "${PROGRAM}" ${ARGN}
    RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE error)
  string(FIND "${error}" "${text}" found)
  if (NOT code STREQUAL "2" OR NOT output STREQUAL "" OR found EQUAL -1)
    message("shadow-storage ${ARGN}\n  exit code ${code}, expected 2\n${output}${error}"
      "  expected: ${text}")
    math(EXPR failures "${failures} + 1")
    set(failures ${failures} PARENT_SCOPE)
  endif ()
endfunction ()

expect("--figure N" --help)
# 2 tan 45° = 2; 99 / 2 and a hundred times that; 100² and 4 · 99 / 2 + 1.
expect("none,1,4950,4950,10000,10000," --far 100 --half-angle 45 --partitions 1)
expect("W,1,49.5,49.5,10000,10000," --far 100 --half-angle 45 --partitions 1)
expect("FP+W,1,49.5,49.5,199,199," --far 100 --half-angle 45 --partitions 1)
expect("ZP,2,2,90\n" --far 100 --half-angle 45 --partitions 2 --light overhead)
expect("ZP+W,2,2,200" --far 100 --light 0,0,-3)
foreach (figure IN ITEMS 5 6 7 10 12 13)
  expect("," --figure ${figure} --far 100)
endforeach ()
expect_refusal("--figure 4: expected one of" --figure 4)
expect_refusal("--figure x" --figure x)
expect_refusal("--light 0,0,0" --light 0,0,0)
expect_refusal("--far" --near 5 --far 4)
expect_refusal("town: expected an option" town)
if (failures)
  message(FATAL_ERROR "${failures} failed")
endif ()
