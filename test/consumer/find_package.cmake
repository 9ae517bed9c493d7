# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: builds and runs the users who call find_package().

include("${CMAKE_CURRENT_LIST_DIR}/../package/run.cmake")

file(REMOVE_RECURSE "${SCRATCH}")
# Without optimization: compiling the templates is what takes the time.
run("${CMAKE_COMMAND}"
    -S "${PROJECT_DIR}/test/consumer"
    -B "${SCRATCH}"
    -G "${GENERATOR}"
    "-DCMAKE_PREFIX_PATH=${PREFIX}"
    -DCMAKE_BUILD_TYPE=None
    "-DCMAKE_C_COMPILER=${C_COMPILER}"
    "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
    "-DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}"
    "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}")
run("${CMAKE_COMMAND}" --build "${SCRATCH}")
run("${SCRATCH}/repair_scan")
run("${SCRATCH}/custom_point")
