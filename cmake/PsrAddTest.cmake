# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: one GoogleTest program from all sources of a folder.

# Seconds after which a single test counts as hanging.
set(PSR_TEST_TIMEOUT 300 CACHE STRING "Time limit of one test in seconds")

# A process for each test tells which one crashes or hangs, and lets CTest choose among
# them; starting them takes as long as many of them run.
option(PSR_WHOLE_TEST_PROGRAMS "Run each test program at once, not test by test" OFF)
set(PSR_TESTS_LEFT_OUT "" CACHE STRING
    "Tests that whole programs leave out: patterns of GoogleTest, with : between them")
# Sanitizers for threads have nothing to find in most files.
set(PSR_TEST_NAMES "" CACHE STRING
    "Build only test files in which the name of a test matches this expression")
# Sanitizers look at what is tested, which libraries and programs hold. In the tests' own
# code they find nothing, and compiling it once more is two fifths of a sanitized build.
set(PSR_TEST_OBJECTS "" CACHE PATH
    "Build folder whose test programs are linked anew, where it has any, not compiled anew")
set(psr_links_tests "")
if(EXISTS "${PSR_TEST_OBJECTS}/CMakeCache.txt")
  file(STRINGS "${PSR_TEST_OBJECTS}/CMakeCache.txt" psr_links_tests
       REGEX "^PSR_BUILD_TESTS:BOOL=ON$")
endif()

# Compiling tests takes longer than running them. At -O1 GCC takes values for uninitialized
# that it sees to be set at -O3, and Clang spends most of its time on what it inlines.
# psr_compile_quickly(<target> <0 or 1>): level 0 for tests that compute next to nothing.
function(psr_compile_quickly target level)
  target_compile_options(
    ${target} PRIVATE $<$<NOT:$<CONFIG:Debug>>:-O${level}>
                      $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>
                      "$<$<CXX_COMPILER_ID:Clang>:SHELL:-mllvm -inline-threshold=50>"
                      $<$<BOOL:${PSR_BUILD_FUZZERS}>:-fno-sanitize=all>)
endfunction()

# psr_select_tests(<list of files>): leaves out the tests PSR_TEST_NAMES does not ask for;
# what they share stays.
function(psr_select_tests list)
  set(selected "")
  foreach(source IN LISTS ${list})
    file(STRINGS "${source}" tests REGEX "^TEST(_F|_P)?\\(")
    list(FILTER tests INCLUDE REGEX "${PSR_TEST_NAMES}")
    if(tests OR NOT source MATCHES "_test\\.cpp$")
      list(APPEND selected "${source}")
    endif()
  endforeach()
  if(NOT selected MATCHES "_test\\.cpp")
    set(selected "")
  endif()
  set(${list} ${selected} PARENT_SCOPE)
endfunction()

# psr_add_test_support(<files>): the library test_support, of these or the one there.
function(psr_add_test_support sources)
  set(scope PUBLIC)
  if(psr_links_tests)
    set(scope INTERFACE)
    set(compiled "${PSR_TEST_OBJECTS}/lib/libtest_support.a")
    add_library(test_support INTERFACE)
    target_link_libraries(test_support INTERFACE "${compiled}")
    set_property(GLOBAL APPEND PROPERTY PSR_TEST_PROGRAMS "${compiled}")
  else()
    add_library(test_support STATIC ${sources})
    target_link_libraries(test_support PRIVATE psr_warnings)
    set_target_properties(test_support PROPERTIES LINKER_LANGUAGE CXX)
    psr_precompile_headers(test_support PUBLIC ${PSR_COMMON_HEADERS} <random>
                           <gtest/gtest.h> <pcl/conversions.h>)
    psr_compile_quickly(test_support 1)
    psr_unite_folders(test_support)
  endif()
  target_include_directories(test_support ${scope} "${CMAKE_CURRENT_SOURCE_DIR}")
  target_compile_definitions(
    test_support
    ${scope} PSR_TEST_DATA_DIR="${CMAKE_CURRENT_SOURCE_DIR}/data"
             PSR_SHARED_DATA_DIR="${PROJECT_SOURCE_DIR}/../shared/data")
  target_link_libraries(test_support ${scope} pcl_surface_internal pcl_io pcl_features
                                              GTest::gtest)
endfunction()

# psr_add_compiled(<target> <files>): a test program, of these or of their objects there.
function(psr_add_compiled target sources)
  if(NOT psr_links_tests)
    add_executable(${target} ${sources})
    # Which is only for the same level.
    target_precompile_headers(${target} REUSE_FROM test_support)
    psr_compile_quickly(${target} 1)
    psr_unite_folders(${target})
    file(GENERATE OUTPUT "${PROJECT_BINARY_DIR}/test/${target}.objects"
         CONTENT "$<JOIN:$<TARGET_OBJECTS:${target}>,\n>\n")
    set_property(GLOBAL APPEND PROPERTY PSR_TEST_PROGRAMS ${target})
    return()
  endif()
  set(compiled "${PSR_TEST_OBJECTS}/test/${target}")
  file(CONFIGURE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/empty.cpp" CONTENT "")
  add_executable(${target} "${CMAKE_CURRENT_BINARY_DIR}/empty.cpp")
  target_link_options(${target} PRIVATE "@${compiled}.objects")
  set_target_properties(${target} PROPERTIES LINK_DEPENDS "${compiled}")
  set_property(GLOBAL APPEND PROPERTY PSR_TEST_PROGRAMS "${compiled}")
endfunction()

# psr_add_test_objects(): a target that brings the objects of all test programs up to date,
# here or there; comes after them.
function(psr_add_test_objects)
  get_property(programs GLOBAL PROPERTY PSR_TEST_PROGRAMS)
  if(NOT psr_links_tests)
    add_custom_target(test_objects DEPENDS ${programs})
    return()
  endif()
  add_custom_target(
    test_objects
    COMMAND ${CMAKE_COMMAND} --build "${PSR_TEST_OBJECTS}" --target test_objects
    BYPRODUCTS ${programs}
    USES_TERMINAL VERBATIM)
endfunction()

# psr_add_test(<target> <folder below test/> [WAITS]); nothing when the folder has no test.
# WAITS: its tests mostly wait for programs, so that optimizing them takes longer than it
# saves, and hold code of programs themselves.
function(psr_add_test target folder)
  file(GLOB sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.cpp")
  if(PSR_TEST_NAMES)
    psr_select_tests(sources)
  endif()
  if(NOT sources)
    return()
  endif()
  if("WAITS" IN_LIST ARGN)
    add_executable(${target} ${sources})
    psr_compile_quickly(${target} 0)
    psr_unite_folders(${target})
  else()
    psr_add_compiled(${target} "${sources}")
  endif()
  target_link_libraries(${target} PRIVATE test_support GTest::gtest_main psr_warnings
                                          psr_link_options)
  set_target_properties(${target} PROPERTIES RUNTIME_OUTPUT_DIRECTORY
                                             "${PROJECT_BINARY_DIR}/test")
  if(PSR_WHOLE_TEST_PROGRAMS)
    add_test(NAME ${target} COMMAND ${target} --gtest_brief=1
                                    --gtest_filter=-${PSR_TESTS_LEFT_OUT})
    set_tests_properties(${target} PROPERTIES TIMEOUT 1200)
    return()
  endif()
  # Values of parameters print as addresses, which differ from run to run.
  gtest_discover_tests(
    ${target}
    DISCOVERY_MODE PRE_TEST
    DISCOVERY_TIMEOUT 60
    NO_PRETTY_VALUES
    PROPERTIES TIMEOUT ${PSR_TEST_TIMEOUT})
endfunction()
