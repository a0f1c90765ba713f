# How the parts, programs and tests of the laboratory are made. Sources are globbed: adding a file needs no edit.
include(GNUInstallDirs)

# rayproof_part(NAME FOLDER [LIBRARIES…]): a static library of all sources in FOLDER, linked to LIBRARIES.
# A folder of headers alone, or one still empty, makes an interface library.
function(rayproof_part name folder)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.cpp)
  if(sources)
    add_library(${name} STATIC ${sources})
    target_link_libraries(${name} PRIVATE $<BUILD_INTERFACE:rayproof_flags>)
    set(scope PUBLIC)
  else()
    add_library(${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  target_include_directories(${name} ${scope} $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/property_tests>)
  target_link_libraries(${name} ${scope} rayproof::rayproof ${ARGN})
endfunction()

# rayproof_program(NAME [LIBRARIES…]): the program rayproof-NAME from NAME.cpp and NAME/*.cpp of the current folder.
# The front door finds it in the build tree's bin/, or in libexec/rayproof/ once installed.
function(rayproof_program name)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${name}.cpp
       ${CMAKE_CURRENT_SOURCE_DIR}/${name}/*.cpp)
  if(NOT sources)
    return()
  endif()
  add_executable(rayproof-${name} ${sources})
  target_include_directories(rayproof-${name} PRIVATE ${PROJECT_SOURCE_DIR}/property_tests)
  target_link_libraries(rayproof-${name} PRIVATE rayproof_command_line fmt::fmt ${ARGN} rayproof_flags)
  # What needs speed is in the parts. A command line needs none, and CLI11 is most of what g++ works on here.
  target_compile_options(rayproof-${name} PRIVATE $<$<CONFIG:Release>:-O0>)
  # A program that is optimised all the same sets DISABLE_PRECOMPILE_HEADERS: g++ takes a header of the same level only.
  target_precompile_headers(rayproof-${name} REUSE_FROM rayproof_command_line)
  install(TARGETS rayproof-${name} RUNTIME DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/rayproof COMPONENT programs)
endfunction()

# rayproof_unit_tests(FOLDER [LIBRARIES…]): one executable of the GoogleTests under FOLDER, each a test of CTest.
# The tests know the programs' folder as RAYPROOF_BIN_DIR and the checkout as RAYPROOF_SOURCE_DIR.
function(rayproof_unit_tests folder)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.cpp)
  if(NOT sources)
    return()
  endif()
  add_executable(unit-${folder} ${sources})
  target_include_directories(unit-${folder} PRIVATE ${PROJECT_SOURCE_DIR}/property_tests)
  target_compile_definitions(unit-${folder} PRIVATE RAYPROOF_BIN_DIR="${CMAKE_RUNTIME_OUTPUT_DIRECTORY}"
                                                    RAYPROOF_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  target_link_libraries(unit-${folder} PRIVATE ${ARGN} GTest::gtest_main rayproof_flags)
  # Tests compile sooner so; what they link keeps its own level. Those that compute much themselves are optimised a little.
  set(level -O0)
  if(folder MATCHES "^(batch|oracle|properties|generators|viz|vtk)$")
    set(level -O1)
  endif()
  target_compile_options(unit-${folder} PRIVATE $<$<CONFIG:Release>:${level}>)
  # What nearly all tests include is read once for all of a level, since g++ takes a header of the same level only.
  get_property(owner GLOBAL PROPERTY rayproof_test_headers${level})
  if(owner)
    target_precompile_headers(unit-${folder} REUSE_FROM ${owner})
  else()
    target_precompile_headers(unit-${folder} PRIVATE <gtest/gtest.h> <nlohmann/json.hpp> <fmt/format.h> <glm/glm.hpp>)
    set_property(GLOBAL PROPERTY rayproof_test_headers${level} unit-${folder})
  endif()
  gtest_discover_tests(unit-${folder} TEST_PREFIX ${folder}/ DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60)
endfunction()
