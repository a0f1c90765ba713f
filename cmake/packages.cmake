# What the laboratory finds on this machine. A missing package turns off what needs it, in one plain line.
set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE TRUE)

# rayproof_find(PACKAGE WHAT ARGUMENTS…): find_package(PACKAGE ARGUMENTS…), or one line saying that WHAT is left out.
macro(rayproof_find package what)
  find_package(${package} ${ARGN} QUIET)
  if(NOT ${package}_FOUND)
    message(STATUS "rayproof: no ${package} found, so ${what} will not be built")
  endif()
endmacro()

find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(fmt REQUIRED)
find_package(TBB REQUIRED)
find_package(Boost REQUIRED)
find_library(RAYPROOF_MPFR mpfr REQUIRED)
rayproof_find(CGAL "the oracle and the programs that ask it")
rayproof_find(rapidcheck "the property tests (rayproof check)")
rayproof_find(GTest "the unit tests")
rayproof_find(VTK "PNG pictures and the window" COMPONENTS CommonCore CommonDataModel CommonComputationalGeometry FiltersSources FiltersCore FiltersGeneral
              FiltersHybrid FiltersModeling RenderingOpenGL2
              RenderingFreeType RenderingAnnotation RenderingContextOpenGL2 RenderingUI InteractionStyle InteractionWidgets ChartsCore IOImage
              IOGeometry IOPLY IOOggTheora)
rayproof_find(embree "the quick search through scenes of many objects" 3)
rayproof_find(benchmark "rayproof-bench")
