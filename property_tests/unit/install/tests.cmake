# Tests of what cmake --install installs, each named as a claim.
set(scripts ${CMAKE_CURRENT_LIST_DIR})
add_test(NAME install/the_library_builds_alone_and_is_found_by_find_package
         COMMAND ${CMAKE_COMMAND} -D SOURCE=${PROJECT_SOURCE_DIR} -D WORK=${PROJECT_BINARY_DIR}/install-library
                 -D COMPILER=${CMAKE_CXX_COMPILER}
                 -D LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER} -P ${scripts}/library.cmake)
add_test(NAME install/every_program_is_installed_listed_and_has_its_options_in_the_manual
         COMMAND ${CMAKE_COMMAND} -D BUILD=${PROJECT_BINARY_DIR} -D WORK=${PROJECT_BINARY_DIR}/install-programs
                 -D MANUAL=${PROJECT_SOURCE_DIR}/docs/programs.md -P ${scripts}/programs.cmake)
