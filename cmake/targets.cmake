# How Timestep compiles: warnings for everything, exact arithmetic for the physics, and the
# helpers that build a source once for each precision.

add_library(timestep_warnings INTERFACE)
target_compile_options(timestep_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow $<$<BOOL:${TIMESTEP_WERROR}>:-Werror>)
# GCC 12 sees overlaps that are not there when strings are joined (its bug 105651)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(timestep_warnings INTERFACE -Wno-restrict)
endif()
target_include_directories(timestep_warnings INTERFACE ${CMAKE_SOURCE_DIR})

if(TIMESTEP_SANITIZE)
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
  # With the sanitizers GCC 12 takes members of <regex> for unset (its bug 105562)
  target_compile_options(timestep_warnings
    INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endif()

if(TIMESTEP_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all)
  add_link_options(-fsanitize=address,undefined)
endif()

# Same input, same bits: no fused multiply-add behind the reader's back. GCC 12's SLP
# vectoriser can drop the rounding of (double)(float)x on neighbouring struct members, so
# it stays off; loops are still vectorised.
add_library(timestep_arithmetic INTERFACE)
target_compile_options(timestep_arithmetic INTERFACE
  -ffp-contract=off $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>)

# timestep_both_precisions(NAME SOURCES…): NAME_single and NAME_double from the same sources
function(timestep_both_precisions name)
  foreach(precision single double)
    string(TOUPPER ${precision} definition)
    add_library(${name}_${precision} STATIC ${ARGN})
    target_compile_definitions(${name}_${precision} PRIVATE TIMESTEP_${definition})
    target_link_libraries(${name}_${precision}
      PRIVATE timestep_warnings timestep_arithmetic PUBLIC glm_headers)
  endforeach()
endfunction()
