# cmake -D "PROGRAMS=unit-lib;unit-case;…" -P test_names.cmake
# Fails where a listed test or a parameter of one is printed as bytes or as an address: nobody can read it, and it
# differs from run to run.
foreach(program IN LISTS PROGRAMS)
  execute_process(COMMAND ${program} --gtest_list_tests OUTPUT_VARIABLE tests COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "\n  [^ \n]" listed "${tests}")
  if(NOT listed)
    message(SEND_ERROR "${program} lists no test")
  endif()
  string(REGEX MATCH "[^\n]*(-byte object|0x)[^\n]*" unreadable "${tests}")
  if(unreadable)
    message(SEND_ERROR "${program} lists: ${unreadable}")
  endif()
endforeach()
