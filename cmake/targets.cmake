# One library a room, one test executable a room.

find_program(CCACHE ccache)
if(CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()

# UBSan's null, alignment and vptr checks are off: with them a sanitized build of Eigen takes a
# third longer. AddressSanitizer catches what a null or stray pointer reads.
add_library(sidestep_options INTERFACE)
target_compile_features(sidestep_options INTERFACE cxx_std_20)
target_include_directories(sidestep_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(sidestep_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wdouble-promotion
  $<$<BOOL:${SIDESTEP_WERROR}>:-Werror>
  $<$<BOOL:${SIDESTEP_SANITIZE}>:-fsanitize=address,undefined -fno-sanitize=null,alignment,vptr
                                 -fno-sanitize-recover=undefined -fno-omit-frame-pointer>)
target_link_options(sidestep_options INTERFACE
  $<$<BOOL:${SIDESTEP_SANITIZE}>:-fsanitize=address,undefined>)
set(CMAKE_CXX_EXTENSIONS OFF)

# Headers that nearly every file reads, parsed once for the rooms and once for the tests.
set(SIDESTEP_COMMON_HEADERS
    <Eigen/Core> <Eigen/Geometry> <algorithm> <cmath> <filesystem> <functional> <map> <memory>
    <optional> <sstream> <string> <vector>)
add_library(sidestep_common_headers STATIC ${CMAKE_CURRENT_LIST_DIR}/precompiled.cc)
target_link_libraries(sidestep_common_headers PUBLIC sidestep_options PkgConfig::EIGEN3)
target_precompile_headers(sidestep_common_headers PRIVATE ${SIDESTEP_COMMON_HEADERS})
add_library(sidestep_test_headers STATIC ${CMAKE_CURRENT_LIST_DIR}/precompiled.cc)
target_link_libraries(sidestep_test_headers PUBLIC sidestep_options PkgConfig::EIGEN3 GTest::gtest)
target_precompile_headers(sidestep_test_headers PRIVATE ${SIDESTEP_COMMON_HEADERS} <gtest/gtest.h>)

# sidestep_room(<name> SOURCES ... DEPENDS ...): static library sidestep_<name>.
function(sidestep_room name)
  cmake_parse_arguments(ROOM "" "" "SOURCES;DEPENDS" ${ARGN})
  add_library(sidestep_${name} STATIC ${ROOM_SOURCES})
  target_link_libraries(sidestep_${name} PUBLIC sidestep_options PkgConfig::EIGEN3 ${ROOM_DEPENDS})
  target_precompile_headers(sidestep_${name} REUSE_FROM sidestep_common_headers)
endfunction()

# sidestep_tests(<name> FILES <files without _test.cc> DEPENDS ... [LABEL unit]): executable
# <name>_test, its cases in ctest. Target <label>_tests builds all of a label.
# SIDESTEP_SOURCE_DIR and SIDESTEP_BINARY (the program) are defined for tests that need files.
include(GoogleTest)
function(sidestep_tests name)
  cmake_parse_arguments(TEST "" "LABEL;TIMEOUT" "FILES;DEPENDS" ${ARGN})
  if(NOT TEST_LABEL)
    set(TEST_LABEL unit)
  endif()
  if(NOT TEST_TIMEOUT)
    set(TEST_TIMEOUT 300)
  endif()
  list(TRANSFORM TEST_FILES APPEND _test.cc)
  add_executable(${name}_test ${TEST_FILES})
  if(NOT TARGET ${TEST_LABEL}_tests)
    add_custom_target(${TEST_LABEL}_tests)
  endif()
  add_dependencies(${TEST_LABEL}_tests ${name}_test)
  target_link_libraries(${name}_test PRIVATE sidestep_options ${TEST_DEPENDS} PkgConfig::EIGEN3
                        GTest::gtest_main)
  target_precompile_headers(${name}_test REUSE_FROM sidestep_test_headers)
  target_compile_definitions(${name}_test PRIVATE
    SIDESTEP_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
    SIDESTEP_BINARY="$<$<TARGET_EXISTS:sidestep>:$<TARGET_FILE:sidestep>>")
  gtest_discover_tests(${name}_test DISCOVERY_MODE PRE_TEST
    PROPERTIES LABELS ${TEST_LABEL} TIMEOUT ${TEST_TIMEOUT} ENVIRONMENT "OMP_NUM_THREADS=1")
endfunction()

# sidestep_bench(<file without _bench.cc> DEPENDS ...): one Google Benchmark executable.
function(sidestep_bench name)
  cmake_parse_arguments(BENCH "" "" "DEPENDS" ${ARGN})
  add_executable(${name}_bench ${name}_bench.cc)
  target_link_libraries(${name}_bench PRIVATE sidestep_options ${BENCH_DEPENDS}
                        benchmark::benchmark_main)
  target_compile_definitions(${name}_bench PRIVATE SIDESTEP_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
endfunction()
