# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: makes the packages of a build and unpacks them side by side.

include("${CMAKE_CURRENT_LIST_DIR}/run.cmake")

# An old copy would hide a header or a file that is no longer installed.
file(REMOVE_RECURSE "${SCRATCH}" "${PACKAGES}")
if(NOT DPKG_DEB)
  run("${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${SCRATCH}/usr")
  return()
endif()
# Not compressed: that would take longer than all the rest.
run("${CPACK}"
    --config "${BUILD_DIR}/CPackConfig.cmake"
    -G DEB
    -D CPACK_DEBIAN_COMPRESSION_TYPE=none)
file(GLOB packages "${PACKAGES}/*.deb")
foreach(package IN LISTS packages)
  run("${DPKG_DEB}" -x "${package}" "${SCRATCH}")
endforeach()
