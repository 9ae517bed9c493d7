# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: language level, output folders, warnings, compiler cache.

option(PSR_WARNINGS_AS_ERRORS "A warning in our own code stops the build"
       ${PSR_IS_TOP_LEVEL})
option(BUILD_SHARED_LIBS "Build shared instead of static libraries" ON)

# Defaults a build of its own wants, but which a project that adds this one as a
# subdirectory decides for itself.
if(PSR_IS_TOP_LEVEL)
  if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "Kind of build" FORCE)
  endif()
  set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")
  set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/lib")
  set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/lib")
  set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
  find_program(PSR_CCACHE ccache)
  mark_as_advanced(PSR_CCACHE)
  if(PSR_CCACHE AND NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER)
    # The same object whatever folder is built in; and without the second setting ccache
    # does not look at sources with a precompiled header.
    set(CMAKE_CXX_COMPILER_LAUNCHER
        "${CMAKE_COMMAND}" -E env "CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}"
        CCACHE_SLOPPINESS=pch_defines,time_macros "${PSR_CCACHE}")
  endif()
endif()

# A cold build then takes about half the time; one that changes single files takes longer,
# and a file that lacks an include may go unnoticed.
option(PSR_UNITY_BUILD "Compile the files of each folder as one" OFF)

# psr_precompile_headers(<target> <PRIVATE or PUBLIC> <header>...): reads headers once for
# all files of a target; PUBLIC where other targets use the same result. A file includes
# what it uses all the same.
function(psr_precompile_headers target scope)
  target_precompile_headers(${target} PRIVATE ${ARGN})
  # Lets the compiler cache look through the precompiled header.
  target_compile_options(
    ${target} ${scope} $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>
                       "$<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>")
endfunction()

# Headers that nearly every file of ours needs: reading them is half of compiling it.
set(PSR_COMMON_HEADERS
    <algorithm>
    <cmath>
    <functional>
    <limits>
    <map>
    <set>
    <string>
    <unordered_map>
    <utility>
    <vector>
    <Eigen/Core>
    <Eigen/Geometry>
    <pcl/PCLPointCloud2.h>
    <pcl/PolygonMesh.h>
    <pcl/point_cloud.h>
    <pcl/point_types.h>)

# psr_unite_folders(<target> [<header>...]): with these headers precompiled. What is
# marked SKIP_UNITY_BUILD_INCLUSION stays apart, and so do kernels, one file a processor,
# whose macros have the same names.
function(psr_unite_folders target)
  if(NOT PSR_UNITY_BUILD)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    get_filename_component(folder "${source}" DIRECTORY)
    get_filename_component(group "${folder}" NAME)
    set_source_files_properties("${source}" PROPERTIES UNITY_GROUP "${group}")
    if(source MATCHES "_(baseline|avx2|avx512)\\.cpp$")
      set_source_files_properties("${source}" PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON
                                                         SKIP_PRECOMPILE_HEADERS ON)
    endif()
  endforeach()
  if(ARGN)
    psr_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()

set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)

# Linked PRIVATE by our own targets, so that no user inherits our warnings.
add_library(psr_warnings INTERFACE)
target_compile_options(
  psr_warnings
  INTERFACE -Wall
            -Wextra
            -Wpedantic
            -Wshadow
            -Wconversion
            $<$<CXX_COMPILER_ID:Clang>:-Wno-sign-conversion>
            $<$<BOOL:${PSR_WARNINGS_AS_ERRORS}>:-Werror>)

# PCL's surface component names all of VTK and Qt; load only what is used.
add_library(psr_link_options INTERFACE)
target_link_options(psr_link_options INTERFACE
                    $<$<PLATFORM_ID:Linux>:LINKER:--as-needed>)
# GNU's linker takes seconds for each of some forty programs, LLVM's a tenth of that.
find_program(PSR_LLD ld.lld)
mark_as_advanced(PSR_LLD)
if(PSR_LLD AND PSR_IS_TOP_LEVEL)
  target_link_options(psr_link_options INTERFACE -fuse-ld=lld)
endif()
