# rtw_warnings(<target>...): the compiler warnings that our own code is held to.
# Generated wrapping code is left out, since its warnings are VTK's.
function (rtw_warnings)
  foreach (target IN LISTS ARGN)
    if (MSVC)
      target_compile_options(${target} PRIVATE /W4 $<$<BOOL:${RTW_WARNINGS_AS_ERRORS}>:/WX>)
    else ()
      target_compile_options(${target} PRIVATE
        -Wall -Wextra $<$<BOOL:${RTW_WARNINGS_AS_ERRORS}>:-Werror>)
    endif ()
  endforeach ()
endfunction ()
