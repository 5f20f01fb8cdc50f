# One place for every flag that can change a number or hide a mistake.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

set(THIGMA_SANITIZE "" CACHE STRING "Sanitizers for everything built here: address, thread or realtime")
option(THIGMA_FUZZ "Fuzz targets of every reader; needs clang" OFF)
option(THIGMA_WERROR "Warnings are errors" OFF)

# Same binary, same bits on every x86-64: no contraction into fused multiply-add, no fast-math,
# no flags for the processor at hand. Wider SIMD lives in files of its own, chosen at run time.
add_library(thigma_flags INTERFACE)
target_compile_options(thigma_flags INTERFACE -ffp-contract=off -fno-fast-math)
target_compile_definitions(thigma_flags INTERFACE EIGEN_MPL2_ONLY)
target_compile_features(thigma_flags INTERFACE cxx_std_20)

# Warnings are for our own sources only, never for those who link to us.
add_library(thigma_warnings INTERFACE)
target_compile_options(thigma_warnings INTERFACE
  -Wall -Wextra -Wshadow -Wnon-virtual-dtor -Wconversion -Wno-sign-conversion
  $<$<BOOL:${THIGMA_WERROR}>:-Werror>)

if(THIGMA_SANITIZE STREQUAL "address")
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
elseif(THIGMA_SANITIZE STREQUAL "thread")
  add_compile_options(-fsanitize=thread -fno-omit-frame-pointer)
  add_link_options(-fsanitize=thread)
elseif(THIGMA_SANITIZE STREQUAL "realtime")
  add_compile_options(-fsanitize=realtime)
  add_link_options(-fsanitize=realtime)
elseif(THIGMA_SANITIZE)
  message(FATAL_ERROR "THIGMA_SANITIZE must be empty, address, thread or realtime")
endif()

if(THIGMA_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link)  # coverage; the programs add the fuzzer itself
endif()

find_program(THIGMA_CCACHE ccache)
if(THIGMA_CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${THIGMA_CCACHE})
endif()
