# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: installation and the exported CMake package. The components
# are those of PsrPackage: runtime, dev, tools, doc.

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
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT runtime
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
          COMPONENT runtime
          NAMELINK_COMPONENT dev
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev)
install(
  EXPORT PclSurfaceRepairTargets
  NAMESPACE PclSurfaceRepair::
  DESTINATION "${psr_package_dir}"
  COMPONENT dev)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/surface_ccaa/include/pcl"
                  "${PROJECT_SOURCE_DIR}/surface_repair/include/pcl"
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        COMPONENT dev)
install(FILES "${PROJECT_BINARY_DIR}/PclSurfaceRepairConfig.cmake"
              "${PROJECT_BINARY_DIR}/PclSurfaceRepairConfigVersion.cmake"
        DESTINATION "${psr_package_dir}"
        COMPONENT dev)

if(NOT PSR_IS_TOP_LEVEL)
  return()
endif()
# The pages keep their places to each other, so that their links work; the examples come
# as source, the site when scripts/build_docs.sh has made it.
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" "${PROJECT_SOURCE_DIR}/README.md"
              "${PROJECT_SOURCE_DIR}/CHANGELOG.md"
        DESTINATION ${CMAKE_INSTALL_DOCDIR}
        COMPONENT doc)
install(FILES "${PROJECT_SOURCE_DIR}/surface_repair/README.md"
        DESTINATION ${CMAKE_INSTALL_DOCDIR}/surface_repair
        COMPONENT doc)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/doc"
        DESTINATION ${CMAKE_INSTALL_DOCDIR}
        COMPONENT doc
        PATTERN "doxygen" EXCLUDE)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/test/consumer"
        DESTINATION ${CMAKE_INSTALL_DOCDIR}/test
        COMPONENT doc
        PATTERN "*.cmake" EXCLUDE)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/build/docs/html"
        DESTINATION ${CMAKE_INSTALL_DOCDIR}
        COMPONENT doc
        OPTIONAL)
