# Tests of what cmake --install installs, each named as a claim.
set(scripts ${CMAKE_CURRENT_LIST_DIR})
add_test(NAME install/every_program_is_installed_listed_and_has_its_options_in_the_manual
         COMMAND ${CMAKE_COMMAND} -D BUILD=${PROJECT_BINARY_DIR} -D WORK=${PROJECT_BINARY_DIR}/install-programs
                 -D MANUAL=${PROJECT_SOURCE_DIR}/docs/programs.md -P ${scripts}/programs.cmake)

find_package(Python3 COMPONENTS Interpreter)
if(NOT Python3_FOUND)
  message(STATUS "rayproof: no Python found, so the tests of the installed library are left out")
  return()
endif()

# rayproof_library_test(NAME CLAIM PROPERTIES…): one claim of library/__main__.py.
function(rayproof_library_test name claim)
  add_test(NAME install/${name}
           COMMAND ${Python3_EXECUTABLE} ${scripts}/library ${claim} --source ${PROJECT_SOURCE_DIR}
                   --work ${PROJECT_BINARY_DIR}/install-library --compiler ${CMAKE_CXX_COMPILER}
                   --launcher "${CMAKE_CXX_COMPILER_LAUNCHER}")
  set_tests_properties(install/${name} PROPERTIES ${ARGN})
endfunction()

# README's recipe builds the library once, for all of them.
set(installed FIXTURES_REQUIRED installed_library)
rayproof_library_test(the_readmes_commands_build_and_install_the_library installation FIXTURES_SETUP installed_library)
rayproof_library_test(the_readmes_project_prints_what_the_readme_says project ${installed})
rayproof_library_test(every_example_in_the_headers_and_in_the_manual_runs comments ${installed})
rayproof_library_test(the_manual_names_the_flags_of_the_target_and_how_to_do_without flags ${installed})
rayproof_library_test(a_batch_without_kernels_is_refused_in_one_sentence kernels ${installed})
rayproof_library_test(fast_math_is_refused_in_one_sentence_unless_allowed fast_math ${installed})
rayproof_library_test(every_header_that_computes_refuses_fast_math reach ${installed})
