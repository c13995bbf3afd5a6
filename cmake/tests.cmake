# One test executable a room, and benchmarks.
include(GoogleTest)
find_package(GTest REQUIRED)
find_package(benchmark REQUIRED)

# As SIDESTEP_COMMON_HEADERS, for the tests.
add_library(sidestep_test_headers STATIC ${CMAKE_CURRENT_LIST_DIR}/precompiled.cc)
target_link_libraries(sidestep_test_headers PUBLIC sidestep_options PkgConfig::EIGEN3 GTest::gtest)
target_precompile_headers(sidestep_test_headers PRIVATE ${SIDESTEP_COMMON_HEADERS} <gtest/gtest.h>)

# sidestep_tests(<name> FILES <files without _test.cc> DEPENDS ... [LABEL unit]): executable
# <name>_test, its cases in ctest. Target <label>_tests builds all of a label.
# SIDESTEP_SOURCE_DIR and SIDESTEP_BINARY (the program) are defined for tests that need files.
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
