# What is compiled once for each instruction set: the batch kernels (lib) and the floor under them (bench).
set(RAYPROOF_INSTRUCTION_SETS all CACHE STRING
    "What the batch kernels are built for: all, native (the widest set of this machine), or a list of baseline, avx2 and avx512")

set(RAYPROOF_FLAGS_baseline)
set(RAYPROOF_FLAGS_avx2 -march=x86-64-v3)
set(RAYPROOF_FLAGS_avx512 -march=x86-64-v4)
set(rayproof_known_sets baseline)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  list(APPEND rayproof_known_sets avx2 avx512)
endif()

# rayproof_native_set(VARIABLE): the widest set that this machine has, as the compiler sees it; what lib/src/instruction_set.cpp
# asks the machine for where a program runs must be there.
function(rayproof_native_set result)
  set(asked_by_avx2 __AVX2__ __FMA__ __BMI__ __BMI2__)
  set(asked_by_avx512 ${asked_by_avx2} __AVX512F__ __AVX512BW__ __AVX512CD__ __AVX512DQ__ __AVX512VL__)
  execute_process(COMMAND ${CMAKE_CXX_COMPILER} -march=native -dM -E -x c++ /dev/null
                  OUTPUT_VARIABLE macros ERROR_QUIET)
  foreach(instruction_set IN LISTS rayproof_known_sets)
    set(missing ${asked_by_${instruction_set}})
    foreach(macro IN LISTS asked_by_${instruction_set})
      if(macros MATCHES "#define ${macro} 1")
        list(REMOVE_ITEM missing ${macro})
      endif()
    endforeach()
    if(NOT missing)
      set(widest ${instruction_set})
    endif()
  endforeach()
  set(${result} ${widest} PARENT_SCOPE)
endfunction()

# rayproof_built_sets: in ascending order of width.
set(rayproof_built_sets)
if(RAYPROOF_INSTRUCTION_SETS STREQUAL "all")
  set(rayproof_built_sets ${rayproof_known_sets})
elseif(RAYPROOF_INSTRUCTION_SETS STREQUAL "native")
  rayproof_native_set(rayproof_built_sets)
else()
  list(JOIN rayproof_known_sets ", " choices)
  foreach(instruction_set IN LISTS RAYPROOF_INSTRUCTION_SETS)
    if(NOT instruction_set IN_LIST rayproof_known_sets)
      message(FATAL_ERROR "RAYPROOF_INSTRUCTION_SETS: there is no '${instruction_set}'; it is all, native, or a list of ${choices}")
    endif()
  endforeach()
  foreach(instruction_set IN LISTS rayproof_known_sets)
    if(instruction_set IN_LIST RAYPROOF_INSTRUCTION_SETS)
      list(APPEND rayproof_built_sets ${instruction_set})
    endif()
  endforeach()
endif()

if(NOT rayproof_built_sets)
  message(FATAL_ERROR "RAYPROOF_INSTRUCTION_SETS is empty; it is all, native, or a list of ${choices}")
endif()

# rayproof_built_for(TARGET): gives the target's sources the list of sets, for templates.
function(rayproof_built_for target)
  list(TRANSFORM rayproof_built_sets PREPEND "InstructionSet::" OUTPUT_VARIABLE sets)
  list(JOIN sets "," sets)
  target_compile_definitions(${target} PRIVATE "RAYPROOF_BUILT_FOR=${sets}")
endfunction()
