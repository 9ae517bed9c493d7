# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: installs the build, then builds and runs a user of it.

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "failed (${result}): ${command}")
  endif()
endfunction()

# An old copy would hide a header or a file that is no longer installed.
file(REMOVE_RECURSE "${SCRATCH_DIR}")
run("${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${SCRATCH_DIR}/prefix")
run("${CMAKE_COMMAND}"
    -S "${CONSUMER_DIR}"
    -B "${SCRATCH_DIR}/build"
    -G "${GENERATOR}"
    "-DCMAKE_PREFIX_PATH=${SCRATCH_DIR}/prefix"
    -DCMAKE_BUILD_TYPE=Release
    "-DCMAKE_C_COMPILER=${C_COMPILER}"
    "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
    "-DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}"
    "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}")
run("${CMAKE_COMMAND}" --build "${SCRATCH_DIR}/build")
run("${SCRATCH_DIR}/build/consumer")
