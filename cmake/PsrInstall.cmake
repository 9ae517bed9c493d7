# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: installation and the exported CMake package.

include(CMakePackageConfigHelpers)
set(psr_package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/PclSurfaceRepair")
string(REPLACE ";" " " PSR_PCL_COMPONENTS_WORDS "${PSR_PCL_COMPONENTS}")

configure_package_config_file(
  "${PROJECT_SOURCE_DIR}/cmake/PclSurfaceRepairConfig.cmake.in"
  "${PROJECT_BINARY_DIR}/PclSurfaceRepairConfig.cmake"
  INSTALL_DESTINATION "${psr_package_dir}")
# Before 1.0 a minor version may break its users.
write_basic_package_version_file(
  "${PROJECT_BINARY_DIR}/PclSurfaceRepairConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)

install(
  TARGETS pcl_surface_ccaa pcl_surface_repair
  EXPORT PclSurfaceRepairTargets
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR}
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(
  EXPORT PclSurfaceRepairTargets
  NAMESPACE PclSurfaceRepair::
  DESTINATION "${psr_package_dir}")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/surface_ccaa/include/pcl"
                  "${PROJECT_SOURCE_DIR}/surface_repair/include/pcl"
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(FILES "${PROJECT_BINARY_DIR}/PclSurfaceRepairConfig.cmake"
              "${PROJECT_BINARY_DIR}/PclSurfaceRepairConfigVersion.cmake"
        DESTINATION "${psr_package_dir}")
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" "${PROJECT_SOURCE_DIR}/README.md"
        DESTINATION ${CMAKE_INSTALL_DOCDIR})
