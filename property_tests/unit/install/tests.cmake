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

# rayproof_package_test(NAME CLAIM WORK PROPERTIES…): one claim of library/__main__.py, in the build's folder WORK.
function(rayproof_package_test name claim work)
  add_test(NAME install/${name}
           COMMAND ${Python3_EXECUTABLE} ${scripts}/library ${claim} --source ${PROJECT_SOURCE_DIR}
                   --work ${PROJECT_BINARY_DIR}/${work} --compiler ${CMAKE_CXX_COMPILER}
                   --launcher "${CMAKE_CXX_COMPILER_LAUNCHER}" --build ${PROJECT_BINARY_DIR} "--flags=${CMAKE_CXX_FLAGS}")
  if(ARGN)
    set_tests_properties(install/${name} PROPERTIES ${ARGN})
  endif()
endfunction()

# README's recipe builds the library once, for all of them.
set(installed install-library FIXTURES_REQUIRED installed_library)
rayproof_package_test(the_readmes_commands_build_and_install_the_library installation
                      install-library FIXTURES_SETUP installed_library COST 900)
rayproof_package_test(the_readmes_project_prints_what_the_readme_says project ${installed})
rayproof_package_test(the_example_of_a_batch_prints_what_its_page_says batch_example ${installed})
rayproof_package_test(every_example_in_the_headers_and_in_the_manual_runs comments ${installed} LABELS content)
rayproof_package_test(the_manual_names_the_flags_of_the_target_and_how_to_do_without flags ${installed})
rayproof_package_test(a_batch_without_kernels_is_refused_in_one_sentence kernels ${installed})
rayproof_package_test(the_batch_kernels_are_those_of_the_instruction_sets_that_were_asked_for sets ${installed} LABELS content)
rayproof_package_test(fast_math_is_refused_in_one_sentence_unless_allowed fast_math ${installed})
rayproof_package_test(every_header_that_computes_refuses_fast_math reach ${installed})
rayproof_package_test(the_library_alone_says_that_it_has_no_laboratory absent ${installed})
if(TARGET rayproof_properties)
  rayproof_package_test(a_property_of_twenty_lines_finds_a_case_of_three_digits laboratory install-laboratory
                        FIXTURES_SETUP installed_laboratory COST 500)
  rayproof_package_test(a_googletest_suite_of_twenty_lines_finds_the_mistake googletest_example
                        install-laboratory FIXTURES_REQUIRED installed_laboratory)
endif()
