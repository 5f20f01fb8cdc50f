# Headers that nearly every file reads (Eigen, the standard library, GoogleTest, the parser of options) are parsed once:
# half of the time of a build was theirs. Off by default and in the dev preset, which so finds includes that are missing.
option(THIGMA_PRECOMPILED_HEADERS "Parse common headers once a build" OFF)

set(THIGMA_COMMON_HEADERS <algorithm> <array> <cmath> <cstdint> <functional> <memory> <optional> <string> <vector>
    <Eigen/Core> <Eigen/Geometry>)

# ccache keeps such builds only where it is told that a header read twice is the same.
if(THIGMA_PRECOMPILED_HEADERS AND CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros
      ${CMAKE_CXX_COMPILER_LAUNCHER})
endif()

# thigma_precompile(TARGET KIND [HEADER ...]): the common headers and these; the first target of a kind (libraries, tests)
# makes them for all of that kind. Files with flags of their own read headers as they stand.
function(thigma_precompile target kind)
  if(NOT THIGMA_PRECOMPILED_HEADERS)
    return()
  endif()
  get_property(owner GLOBAL PROPERTY THIGMA_PRECOMPILED_${kind})
  if(owner)
    target_precompile_headers(${target} REUSE_FROM ${owner})
  else()
    target_precompile_headers(${target} PRIVATE ${THIGMA_COMMON_HEADERS} ${ARGN})
    set_property(GLOBAL PROPERTY THIGMA_PRECOMPILED_${kind} ${target})
  endif()
  # What GCC's preprocessor hands to ccache then names them.
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    target_compile_options(${target} PRIVATE -fpch-preprocess)
  else()
    target_compile_options(${target} PRIVATE "SHELL:-Xclang -fno-pch-timestamp")
  endif()
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "_avx2\\.cpp$")
  if(sources)
    set_source_files_properties(${sources} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
  endif()
endfunction()
