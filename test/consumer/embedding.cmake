# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: configures the user who builds our libraries with its own
# code. They are not built a second time; what would be built is looked at.

include("${CMAKE_CURRENT_LIST_DIR}/../package/run.cmake")

file(REMOVE_RECURSE "${SCRATCH}")
run("${CMAKE_COMMAND}"
    -S "${PROJECT_DIR}/test/consumer/embedding"
    -B "${SCRATCH}"
    -G "${GENERATOR}"
    "-DFETCHCONTENT_SOURCE_DIR_PCLSURFACEREPAIR=${PROJECT_DIR}"
    "-DCMAKE_C_COMPILER=${C_COMPILER}"
    "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}")
execute_process(
  COMMAND "${CMAKE_COMMAND}" --build "${SCRATCH}" --target help
  OUTPUT_VARIABLE targets COMMAND_ERROR_IS_FATAL ANY)
if(NOT targets MATCHES "pcl_surface_repair")
  message(FATAL_ERROR "the library is not among the targets:\n${targets}")
endif()
if(targets MATCHES "test_apps|pcl_repair_holes|program_pages|/packages?[:\n]")
  message(FATAL_ERROR "programs, tests or packages among the targets:\n${targets}")
endif()
