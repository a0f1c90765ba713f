# rayproof-lab: a link to the script in the build tree, and once installed; with it the labs and the headers they need.
find_package(Python3 COMPONENTS Interpreter)
if(NOT Python3_FOUND OR NOT TARGET rayproof-check)
  return()
endif()
add_custom_target(rayproof-lab ALL COMMAND ${CMAKE_COMMAND} -E create_symlink ${PROJECT_SOURCE_DIR}/labs/lab.py
                  ${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/rayproof-lab)
add_dependencies(rayproof-lab rayproof-check rayproof-leak)  # lab 11 is judged by rays at a mesh

set(programs ${CMAKE_INSTALL_LIBEXECDIR}/rayproof)
install(DIRECTORY labs DESTINATION ${programs} COMPONENT programs USE_SOURCE_PERMISSIONS
        PATTERN __pycache__ EXCLUDE PATTERN wrong EXCLUDE)
install(DIRECTORY lib/include/rayproof property_tests/answering property_tests/case
        DESTINATION ${programs}/labs/include COMPONENT programs FILES_MATCHING PATTERN "*.hpp")
install(FILES property_tests/answer_cases.hpp DESTINATION ${programs}/labs/include COMPONENT programs)
install(CODE "file(CREATE_LINK labs/lab.py \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${programs}/rayproof-lab\" SYMBOLIC)"
        COMPONENT programs)
