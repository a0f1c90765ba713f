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
option(RAYPROOF_WERROR "Treat warnings as errors" OFF)

# Warnings for our own targets only; contraction off everywhere so that the same source gives the same bits.
add_library(rayproof_flags INTERFACE)
target_compile_options(rayproof_flags INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow -ffp-contract=off
                                                $<$<BOOL:${RAYPROOF_WERROR}>:-Werror>)
