# Debian packages only; each missing one is named with the package that brings it.
function(thigma_need package variable header)
  find_path(${variable} ${header} PATH_SUFFIXES eigen3)
  if(NOT ${variable})
    message(FATAL_ERROR "thigma: ${header} not found: apt-get install ${package} (or run ./scripts/setup)")
  endif()
endfunction()

find_package(Eigen3 3.4 QUIET NO_MODULE)
if(NOT Eigen3_FOUND)
  message(FATAL_ERROR "thigma: Eigen 3.4 not found: apt-get install libeigen3-dev (or run ./scripts/setup)")
endif()
find_package(Threads REQUIRED)
thigma_need(nlohmann-json3-dev THIGMA_JSON_INCLUDE nlohmann/json.hpp)  # recordings; in sources only, never in headers
thigma_need(libtomlplusplus-dev THIGMA_TOML_INCLUDE toml++/toml.h)  # scenes; likewise
# Recordings are compressed where it is there; without it they are five times as long, and those that are compressed are
# refused.
find_path(THIGMA_ZSTD_INCLUDE zstd.h)
find_library(THIGMA_ZSTD_LIBRARY zstd)
if(THIGMA_ZSTD_INCLUDE AND THIGMA_ZSTD_LIBRARY)
  set(THIGMA_HAS_ZSTD ON)
  add_library(thigma::zstd UNKNOWN IMPORTED GLOBAL)
  set_target_properties(thigma::zstd PROPERTIES IMPORTED_LOCATION "${THIGMA_ZSTD_LIBRARY}"
                                                INTERFACE_INCLUDE_DIRECTORIES "${THIGMA_ZSTD_INCLUDE}"
                                                INTERFACE_COMPILE_DEFINITIONS THIGMA_HAS_ZSTD)
else()
  set(THIGMA_HAS_ZSTD OFF)
  message(STATUS "thigma: recordings will not be compressed: apt-get install libzstd-dev")
endif()
if(THIGMA_BUILD_APPS)
  thigma_need(libboost-dev THIGMA_BOOST_INCLUDE boost/beast.hpp)  # the live page's server
  thigma_need(libcli11-dev THIGMA_CLI11_INCLUDE CLI/CLI.hpp)
  thigma_need(libcairo2-dev THIGMA_CAIRO_INCLUDE cairo/cairo.h)  # plots of experiments
  find_library(THIGMA_CAIRO_LIBRARY cairo REQUIRED)
  thigma_need(libpng-dev THIGMA_PNG_INCLUDE png.h)  # height maps
  find_library(THIGMA_PNG_LIBRARY png REQUIRED)
endif()
if(THIGMA_BUILD_TESTS)
  find_package(GTest QUIET)
  if(NOT GTest_FOUND)
    message(FATAL_ERROR "thigma: GoogleTest not found: apt-get install libgtest-dev (or run ./scripts/setup)")
  endif()
endif()
