# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: Debian packages, a component each: libraries, headers,
# programs, documentation. scripts/build_packages.sh makes them.

set(PSR_PACKAGE_MAINTAINER
    "PclSurfaceRepair contributors <maintainers@pclsurfacerepair.invalid>"
    CACHE STRING "Maintainer of the packages, with an address")
set(PSR_PACKAGE_RELEASE 1 CACHE STRING "Debian revision of the packages")

find_program(PSR_DPKG dpkg)
find_program(PSR_GZIP gzip)
mark_as_advanced(PSR_DPKG PSR_GZIP)
if(NOT PSR_DPKG OR NOT PSR_GZIP)
  return()
endif()

# The libraries' package changes its name with their binary interface.
set(psr_package_runtime
    "libpclsurfacerepair${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}")
set(psr_package_dev libpclsurfacerepair-dev)
set(psr_package_tools pclsurfacerepair-tools)
set(psr_package_doc libpclsurfacerepair-doc)
set(psr_package_python python3-pcl-surface-repair)
set(psr_components runtime dev doc)
if(PSR_BUILD_APPS)
  list(APPEND psr_components tools)
endif()
if(TARGET pclsurfacerepair_python)
  list(APPEND psr_components python)
endif()

# What Debian wants beside every package: licence, changelogs, exceptions.
set(psr_debian "${PROJECT_BINARY_DIR}/debian")
function(psr_compress input output)
  execute_process(COMMAND "${PSR_GZIP}" -9nc "${input}" OUTPUT_FILE "${output}"
                                                        COMMAND_ERROR_IS_FATAL ANY)
endfunction()
string(TIMESTAMP psr_package_date "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(READ "${PROJECT_SOURCE_DIR}/LICENSE" psr_license)
string(REGEX REPLACE "^.*All rights reserved.\n\n" "" psr_license "${psr_license}")
string(REGEX REPLACE "\n+$" "" psr_license "${psr_license}")
string(REPLACE "\n\n" "\n.\n" psr_license "${psr_license}")
string(REPLACE "\n" "\n " psr_license "${psr_license}")
configure_file("${PROJECT_SOURCE_DIR}/cmake/debian/copyright.in"
               "${psr_debian}/copyright" @ONLY)
configure_file("${PROJECT_SOURCE_DIR}/cmake/debian/changelog.in"
               "${psr_debian}/changelog.Debian" @ONLY)
psr_compress("${psr_debian}/changelog.Debian" "${psr_debian}/changelog.Debian.gz")
psr_compress("${PROJECT_SOURCE_DIR}/CHANGELOG.md" "${psr_debian}/changelog.gz")
foreach(psr_component IN LISTS psr_components)
  install(
    FILES "${psr_debian}/copyright" "${psr_debian}/changelog.Debian.gz"
          "${psr_debian}/changelog.gz"
    DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/doc/${psr_package_${psr_component}}"
    COMPONENT ${psr_component}
    EXCLUDE_FROM_ALL)
  set(psr_package "${psr_package_${psr_component}}")
  configure_file("${PROJECT_SOURCE_DIR}/cmake/debian/lintian-overrides.in"
                 "${psr_debian}/${psr_package}" @ONLY)
  if(psr_component STREQUAL runtime)
    file(APPEND "${psr_debian}/${psr_package}"
"# Two libraries that are released together.
${psr_package}: package-name-doesnt-match-sonames *
# CPack writes the scripts.
${psr_package}: maintscript-calls-ldconfig *
")
  endif()
  install(
    FILES "${psr_debian}/${psr_package}"
    DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/lintian/overrides"
    COMPONENT ${psr_component}
    EXCLUDE_FROM_ALL)
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME pclsurfacerepair)
set(CPACK_PACKAGE_VENDOR "PclSurfaceRepair contributors")
set(CPACK_PACKAGE_DIRECTORY "${PROJECT_BINARY_DIR}/packages")
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_COMPONENTS_ALL ${psr_components})
# Each package has a title of its own.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_PACKAGING_INSTALL_PREFIX "/usr")
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
    WORLD_EXECUTE)
set(CPACK_PRE_BUILD_SCRIPTS "${PROJECT_SOURCE_DIR}/cmake/PsrRemoveRpath.cmake")

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE "${PSR_PACKAGE_RELEASE}")
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "${PSR_PACKAGE_MAINTAINER}")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
# Our own libraries belong to no installed package yet.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
set(psr_same_version "(= ${PROJECT_VERSION}-${PSR_PACKAGE_RELEASE})")
# psr_describe(<component> <what the package is> <what is in it>); the first line of a
# description is a title.
macro(psr_describe component title contents)
  set(CPACK_DEBIAN_${component}_DESCRIPTION
      "surface reconstruction and hole repair in PCL's terms - ${title}
PclSurfaceRepair turns point clouds into triangle meshes and repairs the
holes and islands of any triangle mesh, in terms of the Point Cloud
Library (PCL).

This package contains ${contents}.")
endmacro()

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME ${psr_package_runtime})
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)
psr_describe(RUNTIME libraries "the shared libraries")
file(WRITE "${psr_debian}/triggers" "activate-noawait ldconfig\n")
# Which package others need that link the libraries. CPack would write it, too, but looks
# at every file of every package for that.
set(psr_soname_version "${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}")
file(WRITE "${psr_debian}/shlibs" "")
foreach(psr_library IN ITEMS pcl_surface_ccaa pcl_surface_repair)
  file(APPEND "${psr_debian}/shlibs"
       "lib${psr_library} ${psr_soname_version} ${psr_package_runtime} "
       "(>= ${PROJECT_VERSION})\n")
endforeach()
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA "${psr_debian}/triggers"
                                               "${psr_debian}/shlibs")

set(CPACK_DEBIAN_DEV_PACKAGE_NAME ${psr_package_dev})
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS
    "${psr_package_runtime} ${psr_same_version}, libpcl-dev (>= ${PSR_PCL_MINIMUM})")
set(CPACK_DEBIAN_DEV_PACKAGE_SUGGESTS "${psr_package_doc}")
psr_describe(DEV headers "the headers, the CMake package and the pkg-config files")

set(CPACK_DEBIAN_TOOLS_PACKAGE_NAME ${psr_package_tools})
set(CPACK_DEBIAN_TOOLS_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_TOOLS_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_TOOLS_PACKAGE_DEPENDS "${psr_package_runtime} ${psr_same_version}")
# Pictures without a screen.
set(CPACK_DEBIAN_TOOLS_PACKAGE_RECOMMENDS xvfb)
set(CPACK_DEBIAN_TOOLS_PACKAGE_SUGGESTS "pcl-tools, snakemake, ${psr_package_doc}")
psr_describe(TOOLS programs
             "the programs, with manual pages and completion for bash")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME ${psr_package_python})
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
# A module is for one minor version of Python.
math(EXPR psr_next_python "${PSR_PYTHON_MINOR} + 1")
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "${psr_package_runtime} ${psr_same_version}, python3-numpy, python3 (>= 3.${PSR_PYTHON_MINOR}), python3 (<< 3.${psr_next_python})")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-tqdm, ${psr_package_doc}")
psr_describe(PYTHON "Python package"
             "the module pclsurfacerepair, over numpy arrays")
# Byte code comes and goes with the package.
set(psr_script "#!/bin/sh\nset -e\n")
file(WRITE "${psr_debian}/python/postinst"
     "${psr_script}[ \"$1\" != configure ] || py3compile -p ${psr_package_python}\n")
file(WRITE "${psr_debian}/python/prerm" "${psr_script}py3clean -p ${psr_package_python}\n")
file(CHMOD "${psr_debian}/python/postinst" "${psr_debian}/python/prerm" FILE_PERMISSIONS
     OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
     WORLD_EXECUTE)
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA "${psr_debian}/python/postinst"
                                              "${psr_debian}/python/prerm")

set(CPACK_DEBIAN_DOC_PACKAGE_NAME ${psr_package_doc})
set(CPACK_DEBIAN_DOC_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_DOC_PACKAGE_SECTION doc)
psr_describe(DOC documentation "the manual and the sources of the examples")

include(CPack)
