# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: builds and runs the user who has a Makefile and pkg-config.

include("${CMAKE_CURRENT_LIST_DIR}/../package/run.cmake")

file(REMOVE_RECURSE "${SCRATCH}")
file(MAKE_DIRECTORY "${SCRATCH}")
run(make
    -C "${SCRATCH}"
    -f "${PROJECT_DIR}/test/consumer/Makefile"
    "VPATH=${PROJECT_DIR}/test/consumer"
    "CXX=${LAUNCHER} ${CXX_COMPILER}"
    "CXXFLAGS=-O0 ${CXX_FLAGS}"
    "PKG_CONFIG_PATH=${PREFIX}/${LIBDIR}/pkgconfig")
run("${SCRATCH}/repair_scan")
