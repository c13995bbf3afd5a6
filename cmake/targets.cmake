# One library a room. Tests, an executable a room, are in tests.cmake.

find_program(CCACHE ccache)
if(CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()

# UBSan's null, alignment and vptr checks are off: with them a sanitized build of Eigen takes a
# third longer. AddressSanitizer catches what a null or stray pointer reads.
add_library(sidestep_options INTERFACE)
target_compile_features(sidestep_options INTERFACE cxx_std_20)
target_include_directories(sidestep_options INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
  $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/sidestep>)
# Users of the installed libraries choose their own warnings, but not how Eigen aligns: our libraries
# are built for any x86-64, and their own -march=native would move the members of our structs and
# free vectors in another way than we allocate them.
target_compile_options(sidestep_options INTERFACE
  "$<BUILD_INTERFACE:-Wall;-Wextra;-Wpedantic;-Wshadow;-Wconversion;-Wdouble-promotion>"
  $<BUILD_INTERFACE:$<$<BOOL:${SIDESTEP_WERROR}>:-Werror>>
  $<$<BOOL:${SIDESTEP_SANITIZE}>:-fsanitize=address,undefined -fno-sanitize=null,alignment,vptr
                                 -fno-sanitize-recover=undefined -fno-omit-frame-pointer>)
target_link_options(sidestep_options INTERFACE
  $<$<BOOL:${SIDESTEP_SANITIZE}>:-fsanitize=address,undefined>)
# Fuzzed, the readers have all of UBSan, and the library's own asserts.
if(SIDESTEP_FUZZ)
  set(fuzzed address,undefined,float-cast-overflow)
  target_compile_options(sidestep_options INTERFACE
    $<BUILD_INTERFACE:-fsanitize=fuzzer-no-link,${fuzzed};-fno-sanitize-recover=all;-fno-omit-frame-pointer>)
  target_compile_definitions(sidestep_options INTERFACE $<BUILD_INTERFACE:_GLIBCXX_ASSERTIONS>)
  target_link_options(sidestep_options INTERFACE $<BUILD_INTERFACE:-fsanitize=${fuzzed}>)
endif()
target_compile_definitions(sidestep_options INTERFACE
  "$<INSTALL_INTERFACE:EIGEN_MAX_ALIGN_BYTES=16;EIGEN_MALLOC_ALREADY_ALIGNED=1>")
set(CMAKE_CXX_EXTENSIONS OFF)

# Headers that nearly every file reads, parsed once.
set(SIDESTEP_COMMON_HEADERS
    <Eigen/Core> <Eigen/Geometry> <algorithm> <cmath> <filesystem> <functional> <map> <memory>
    <optional> <sstream> <string> <vector>)
add_library(sidestep_common_headers STATIC ${CMAKE_CURRENT_LIST_DIR}/precompiled.cc)
target_link_libraries(sidestep_common_headers PUBLIC sidestep_options PkgConfig::EIGEN3)
target_precompile_headers(sidestep_common_headers PRIVATE ${SIDESTEP_COMMON_HEADERS})

# sidestep_room(<name> SOURCES ... DEPENDS ...): static library sidestep_<name>.
function(sidestep_room name)
  cmake_parse_arguments(ROOM "" "" "SOURCES;DEPENDS" ${ARGN})
  add_library(sidestep_${name} STATIC ${ROOM_SOURCES})
  target_link_libraries(sidestep_${name} PUBLIC sidestep_options PkgConfig::EIGEN3 ${ROOM_DEPENDS})
  target_precompile_headers(sidestep_${name} REUSE_FROM sidestep_common_headers)
endfunction()
