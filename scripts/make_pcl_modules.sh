#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: lays our two libraries out as modules of PCL's own source tree.
#
# usage: make_pcl_modules.sh FOLDER [--check]
#   FOLDER   gets surface_ccaa and surface_repair, which go beside PCL's surface/, with
#            CMake files as PCL's modules have them
#   --check  then builds them there against the installed PCL, by PCL's macros as far as
#            they matter to a build

set -euo pipefail
[[ $# -ge 1 && $1 != -* ]] || { sed -n '5,10s/^# \?//p' "$0"; exit 1; }
mkdir -p "$1"
target=$(realpath "$1")
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# list FOLDER PATTERN: files below a module's folder, one a line
list() {
  (cd "$target/$module" && find "$1" -name "$2" ${3:+-not -path "$3"} | sort | sed 's/^/  /')
}

# write_module MODULE "DESCRIPTION" "DEPENDENCIES" "FURTHER INCLUDE FOLDERS"
write_module() {
  module=$1
  rm -rf "${target:?}/$module"
  mkdir -p "$target/$module"
  cp -r "$module/include" "$module/src" "$target/$module/"
  cat >"$target/$module/CMakeLists.txt" <<END
set(SUBSYS_NAME $module)
set(SUBSYS_DESC "$2")
set(SUBSYS_DEPS $3)

set(build TRUE)
PCL_SUBSYS_OPTION(build "\${SUBSYS_NAME}" "\${SUBSYS_DESC}" ON)
PCL_SUBSYS_DEPEND(build NAME "\${SUBSYS_NAME}" DEPS \${SUBSYS_DEPS})
PCL_ADD_DOC("\${SUBSYS_NAME}")
if(NOT build)
  return()
endif()

set(srcs
$(list src '*.cpp')
)
set(incs
$(list include '*.h' '*/impl/*')
)
set(impl_incs
$(list include/pcl/$module/impl '*' 2>/dev/null | grep -E '\.h(pp)?$' || true)
)

set(LIB_NAME "pcl_\${SUBSYS_NAME}")
include_directories("\${CMAKE_CURRENT_SOURCE_DIR}/include" "\${CMAKE_CURRENT_SOURCE_DIR}/src"$4)
PCL_ADD_LIBRARY(\${LIB_NAME} COMPONENT \${SUBSYS_NAME} SOURCES \${srcs} \${incs} \${impl_incs})
# The same bits on every processor.
target_compile_options(\${LIB_NAME} PRIVATE -ffp-contract=off)
foreach(dependency IN LISTS SUBSYS_DEPS)
  target_link_libraries(\${LIB_NAME} pcl_\${dependency})
endforeach()
if(TARGET OpenMP::OpenMP_CXX)
  target_link_libraries(\${LIB_NAME} OpenMP::OpenMP_CXX)
endif()
PCL_MAKE_PKGCONFIG(\${LIB_NAME} COMPONENT \${SUBSYS_NAME} DESC \${SUBSYS_DESC} PCL_DEPS \${SUBSYS_DEPS})
PCL_ADD_INCLUDES("\${SUBSYS_NAME}" "\${SUBSYS_NAME}" \${incs})
PCL_ADD_INCLUDES("\${SUBSYS_NAME}" "\${SUBSYS_NAME}/impl" \${impl_incs})
END
}

write_module surface_ccaa "Triangle meshes from point clouds, without normals and parameters" \
  "common search kdtree surface" ""
write_module surface_repair "Islands joined and holes closed in triangle meshes" \
  "common search kdtree surface surface_ccaa" \
  ' "${CMAKE_CURRENT_SOURCE_DIR}/../surface_ccaa/include" "${CMAKE_CURRENT_SOURCE_DIR}/../surface_ccaa/src"'
cp LICENSE "$target/LICENSE.surface_ccaa"
echo "$target: surface_ccaa and surface_repair"
[[ ${2:-} == --check ]] || exit 0

check=$target/check
mkdir -p "$check"
cat >"$check/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.18)
project(pcl_modules C CXX)
set(CMAKE_CXX_STANDARD 17)
find_package(PCL REQUIRED COMPONENTS common search kdtree surface)
find_package(OpenMP REQUIRED COMPONENTS CXX)
include_directories(SYSTEM ${PCL_INCLUDE_DIRS})
add_definitions(-DPCLAPI_EXPORTS)
option(PSR_UNITY_BUILD "Compile folders at once" ON)
include("${PSR_SETTINGS}")
# What PCL's own macros do to a build.
macro(PCL_SUBSYS_OPTION)
endmacro()
macro(PCL_SUBSYS_DEPEND)
endmacro()
macro(PCL_ADD_DOC)
endmacro()
macro(PCL_MAKE_PKGCONFIG)
endmacro()
macro(PCL_ADD_INCLUDES _component _folder)
  foreach(_file ${ARGN})
    if(NOT EXISTS "${CMAKE_CURRENT_SOURCE_DIR}/${_file}")
      message(FATAL_ERROR "${_component}: no ${_file}")
    endif()
  endforeach()
endmacro()
function(PCL_ADD_LIBRARY _name)
  cmake_parse_arguments(ARG "" "COMPONENT" "SOURCES" ${ARGN})
  add_library(${_name} SHARED ${ARG_SOURCES})
  psr_unite_folders(${_name})
endfunction()
add_subdirectory(../surface_ccaa surface_ccaa)
add_subdirectory(../surface_repair surface_repair)
END
cmake -S "$check" -B "$check/build" -G Ninja -DCMAKE_CXX_FLAGS="${CXXFLAGS:--O0}" \
  -DPSR_SETTINGS="$PWD/cmake/PsrBuildSettings.cmake" \
  -DCMAKE_SHARED_LINKER_FLAGS=-Wl,--no-undefined >"$check/configure.log"
cmake --build "$check/build" >"$check/build.log" || { tail -30 "$check/build.log"; exit 1; }
echo "built: $(ls "$check"/build/*/libpcl_surface_*.so | wc -l) libraries"
