# rayproof-docs: a link to the script in the build tree, and the programs that make parts of the pages. What the site itself
# needs is the group `docs` of debian-packages.txt.
find_package(Python3 COMPONENTS Interpreter)
if(NOT Python3_FOUND OR NOT TARGET rayproof-walk)
  return()
endif()
add_custom_target(rayproof-docs ALL COMMAND ${CMAKE_COMMAND} -E create_symlink ${PROJECT_SOURCE_DIR}/docs/site/build.py
                  ${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/rayproof-docs)
add_dependencies(rayproof-docs rayproof-methods rayproof-walk)
