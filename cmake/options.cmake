# Settings every target shares.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

option(RAYPROOF_LAB "Build the laboratory (oracle, property tests, pictures, report), not just the library"
       ${PROJECT_IS_TOP_LEVEL})
option(RAYPROOF_INSTALL "Install the library along with the project that builds it" ${PROJECT_IS_TOP_LEVEL})
option(RAYPROOF_PEERS "Build the programs that put other people's libraries on trial (check --subject)" OFF)
option(RAYPROOF_WERROR "Treat warnings as errors" OFF)

# The same source must give the same bits, in a user's target too (docs/library.md): no contraction, and none of g++ 12's
# basic-block vectorizer, which drops the rounding from double to float and back where two stand side by side (held by
# unit/lib/compiler_test.cpp).
set(RAYPROOF_SAME_BITS
    -ffp-contract=off
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-fno-tree-slp-vectorize>)

# Warnings for our own targets only. g++ 12 sees overlapping copies where std::string concatenates (GCC bug 105651,
# mended in 13).
add_library(rayproof_flags INTERFACE)
target_compile_options(rayproof_flags INTERFACE
  ${RAYPROOF_SAME_BITS} -Wall -Wextra -Wpedantic -Wconversion -Wshadow
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>
  # g++ looks for garbage of its own less often: a twentieth of the time to compile, for no more memory than it takes at its peak.
  $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=524288>
  $<$<BOOL:${RAYPROOF_WERROR}>:-Werror>)
