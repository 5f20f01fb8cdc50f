# thigma_room(NAME SOURCES a.cpp ... [DEPENDS room ...]): one folder, one library, listed sources.
# Objects of every room also go into the one library users link, thigma::thigma.
define_property(GLOBAL PROPERTY THIGMA_ROOMS BRIEF_DOCS "rooms in build order")

function(thigma_room name)
  cmake_parse_arguments(ROOM "" "" "SOURCES;DEPENDS" ${ARGN})
  add_library(thigma_${name} STATIC ${ROOM_SOURCES})
  target_include_directories(thigma_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>)
  target_link_libraries(thigma_${name} PUBLIC Eigen3::Eigen Threads::Threads $<BUILD_INTERFACE:thigma_flags>
                                       PRIVATE $<BUILD_INTERFACE:thigma_warnings>)
  foreach(other IN LISTS ROOM_DEPENDS)
    target_link_libraries(thigma_${name} PUBLIC thigma_${other})
  endforeach()
  thigma_precompile(thigma_${name} libraries)
  set_property(GLOBAL APPEND PROPERTY THIGMA_ROOMS ${name})
endfunction()

# thigma_test_program(NAME SOURCES ... DEPENDS ...): the executable alone, for who adds its ctest entries himself.
function(thigma_test_program name)
  cmake_parse_arguments(P "" "" "SOURCES;DEPENDS" ${ARGN})
  add_executable(${name} ${P_SOURCES})
  add_dependencies(thigma_test_programs ${name})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests ${PROJECT_SOURCE_DIR})
  target_compile_definitions(${name} PRIVATE THIGMA_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  target_link_libraries(${name} PRIVATE ${P_DEPENDS} GTest::gtest GTest::gtest_main thigma_warnings)
  thigma_precompile(${name} tests <gtest/gtest.h>)
  set_target_properties(${name} PROPERTIES UNITY_BUILD OFF)  # files of tests share names
endfunction()

# thigma_test(NAME [THREADS] [REALTIME] SOURCES ... DEPENDS ...): tests/<room>/<file>_test.cpp of one room in one executable.
# THREADS: it starts threads, or a program that does; REALTIME: it calls functions marked THIGMA_RT. The thread and the
# real-time sanitizer can find nothing in the others, which are left out there; the address sanitizer runs them all.
if(THIGMA_BUILD_TESTS)
  add_custom_target(thigma_test_programs)
endif()
function(thigma_test name)
  cmake_parse_arguments(T "THREADS;REALTIME" "LABEL;TIMEOUT" "SOURCES;DEPENDS" ${ARGN})
  if((THIGMA_SANITIZE STREQUAL "thread" AND NOT T_THREADS) OR (THIGMA_SANITIZE STREQUAL "realtime" AND NOT T_REALTIME))
    return()
  endif()
  thigma_test_program(${name} SOURCES ${T_SOURCES} DEPENDS ${T_DEPENDS})
  if(NOT T_LABEL)
    set(T_LABEL unit)
  endif()
  if(NOT T_TIMEOUT)
    set(T_TIMEOUT 1800)  # seconds; generous, for sanitizers on a busy machine
  endif()
  # One ctest entry an executable: gtest's own cases are counted by scripts/test from its XML.
  add_test(NAME ${name} COMMAND ${name} --gtest_output=xml:${CMAKE_BINARY_DIR}/results/${name}.xml)
  set_tests_properties(${name} PROPERTIES LABELS "${T_LABEL}" TIMEOUT ${T_TIMEOUT})
  if(T_LABEL MATCHES "slow|property")
    set_tests_properties(${name} PROPERTIES COST 100)  # begun first, so that none runs alone at the end
  endif()
  thigma_test_environment(${name})
endfunction()

# thigma_test_environment(TEST [NAME=VALUE ...]): levels of detail that a test builds are kept in the build folder,
# for all tests, instead of in the cache folder of whoever runs them.
function(thigma_test_environment name)
  set_property(TEST ${name} APPEND PROPERTY ENVIRONMENT "XDG_CACHE_HOME=${CMAKE_BINARY_DIR}/test_cache" ${ARGN})
  if(THIGMA_SANITIZE STREQUAL "address")
    set(known ${PROJECT_SOURCE_DIR}/tests/support/leaks_of_libraries.txt)
    set_property(TEST ${name} APPEND PROPERTY ENVIRONMENT "LSAN_OPTIONS=suppressions=${known}:print_suppressions=0")
  endif()
endfunction()
