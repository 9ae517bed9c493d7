# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: one GoogleTest program from all sources of a folder.

# Seconds after which a single test counts as hanging.
set(PSR_TEST_TIMEOUT 300 CACHE STRING "Time limit of one test in seconds")

# Headers that nearly every test needs, read once for all of them. A test includes what
# it uses all the same.
function(psr_precompile_test_headers target)
  target_precompile_headers(
    ${target}
    PRIVATE
    <algorithm>
    <cmath>
    <limits>
    <map>
    <random>
    <set>
    <string>
    <utility>
    <vector>
    <Eigen/Core>
    <Eigen/Geometry>
    <gtest/gtest.h>
    <pcl/conversions.h>
    <pcl/point_cloud.h>
    <pcl/point_types.h>
    <pcl/PCLPointCloud2.h>
    <pcl/PolygonMesh.h>)
  # Lets the compiler cache look through the precompiled header.
  target_compile_options(
    ${target} PUBLIC $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>
                     "$<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>")
endfunction()

# psr_add_test(<target> <folder below test/>); nothing when the folder has no source.
function(psr_add_test target folder)
  file(GLOB sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.cpp")
  if(NOT sources)
    return()
  endif()
  add_executable(${target} ${sources})
  target_link_libraries(${target} PRIVATE test_support GTest::gtest_main psr_warnings
                                          psr_link_options)
  target_precompile_headers(${target} REUSE_FROM test_support)
  psr_unite_folders(${target})
  set_target_properties(${target} PROPERTIES RUNTIME_OUTPUT_DIRECTORY
                                             "${PROJECT_BINARY_DIR}/test")
  # Values of parameters print as addresses, which differ from run to run.
  gtest_discover_tests(
    ${target}
    DISCOVERY_MODE PRE_TEST
    DISCOVERY_TIMEOUT 60
    NO_PRETTY_VALUES
    PROPERTIES TIMEOUT ${PSR_TEST_TIMEOUT})
endfunction()
