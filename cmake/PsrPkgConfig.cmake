# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: pkg-config files for those who build without CMake.

# PCL's own files carry its version in their names up to 1.12: take what is there.
set(psr_pcl_pc_suffix "")
find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
  pkg_search_module(PSR_PC_PCL QUIET pcl_common
                    "pcl_common-${PCL_VERSION_MAJOR}.${PCL_VERSION_MINOR}")
  if(PSR_PC_PCL_FOUND)
    string(REGEX REPLACE "^pcl_common" "" psr_pcl_pc_suffix "${PSR_PC_PCL_MODULE_NAME}")
  endif()
endif()

# The prefix follows the file, wherever the installation is moved.
file(RELATIVE_PATH psr_pc_prefix "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
string(REGEX REPLACE "/$" "" psr_pc_prefix "${psr_pc_prefix}")

# psr_write_pc(<module> <description> <required modules>)
function(psr_write_pc module description)
  list(JOIN ARGN " " requires)
  configure_file("${PROJECT_SOURCE_DIR}/cmake/pcl_surface.pc.in"
                 "${PROJECT_BINARY_DIR}/pcl_${module}.pc" @ONLY)
  install(FILES "${PROJECT_BINARY_DIR}/pcl_${module}.pc"
          DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
          COMPONENT dev)
endfunction()

set(psr_pcl_modules ${PSR_PCL_COMPONENTS})
list(TRANSFORM psr_pcl_modules REPLACE "(.+)" "pcl_\\1${psr_pcl_pc_suffix}")
psr_write_pc(surface_ccaa "Triangle meshes from point clouds" ${psr_pcl_modules})
psr_write_pc(surface_repair "Repair of holes and islands of triangle meshes"
             "pcl_surface_ccaa = ${PROJECT_VERSION}")
