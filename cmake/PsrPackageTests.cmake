# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: tests of the packages and of what is installed from them.
# Their names start with "Package".

set(psr_packages "${PROJECT_BINARY_DIR}/packages")
set(psr_prefix "${PROJECT_BINARY_DIR}/test/package/usr")
get_property(psr_programs GLOBAL PROPERTY PSR_PROGRAMS)
find_program(PSR_DPKG_DEB dpkg-deb)
mark_as_advanced(PSR_DPKG_DEB)

# psr_add_package_test(<name> <fixture it needs> <command>)
function(psr_add_package_test name fixture)
  add_test(NAME ${name} COMMAND ${ARGN})
  set_tests_properties(${name} PROPERTIES FIXTURES_REQUIRED "${fixture}" TIMEOUT 600)
endfunction()

# The packages are made and unpacked; where there is no dpkg, the build is installed.
add_test(
  NAME PackagesAreMade
  COMMAND
    ${CMAKE_COMMAND} -D "BUILD_DIR=${PROJECT_BINARY_DIR}" -D "PACKAGES=${psr_packages}"
    -D "SCRATCH=${PROJECT_BINARY_DIR}/test/package" -D "CPACK=${CMAKE_CPACK_COMMAND}"
    -D "DPKG_DEB=${PSR_DPKG_DEB}" -P
    "${CMAKE_CURRENT_SOURCE_DIR}/package/make_and_unpack.cmake")
set_tests_properties(PackagesAreMade PROPERTIES FIXTURES_SETUP packages
                                                FIXTURES_REQUIRED documentation TIMEOUT
                                                                                600)

if(PSR_DPKG_DEB AND psr_programs)
  set(psr_cases runtime dev tools doc site common dependencies)
  if(TARGET pclsurfacerepair_python)
    list(APPEND psr_cases python)
  endif()
  foreach(psr_case IN LISTS psr_cases)
    psr_add_package_test(
      PackageContents.${psr_case} packages bash
      "${CMAKE_CURRENT_SOURCE_DIR}/package/contents_test.sh" ${psr_case}
      "${psr_packages}" "${PROJECT_SOURCE_DIR}" "${PROJECT_VERSION}" ${psr_programs})
  endforeach()
  # The site is there if its test is, whatever has been installed since.
  if(PSR_DOXYGEN)
    set_tests_properties(PackageContents.site PROPERTIES ENVIRONMENT
                                                         "PSR_DOXYGEN=${PSR_DOXYGEN}")
  endif()
  set_tests_properties(PackageContents.site PROPERTIES SKIP_REGULAR_EXPRESSION
                                                       "^skipped:")
endif()

# What of the headers is installed.
foreach(psr_case IN ITEMS list closed alone)
  psr_add_package_test(
    PackageHeaders.${psr_case} packages ${CMAKE_COMMAND} -E env
    "CXX=${CMAKE_CXX_COMPILER}"
    "PKG_CONFIG_PATH=${psr_prefix}/${CMAKE_INSTALL_LIBDIR}/pkgconfig" bash
    "${CMAKE_CURRENT_SOURCE_DIR}/package/headers_test.sh" ${psr_case}
    "${psr_prefix}/include")
endforeach()

# Of a launcher with settings only the launcher: a list would be taken apart on the way.
set(psr_consumer_launcher "")
if(CMAKE_CXX_COMPILER_LAUNCHER)
  list(GET CMAKE_CXX_COMPILER_LAUNCHER -1 psr_consumer_launcher)
endif()

# Programs of users, built with what was unpacked.
foreach(psr_case IN ITEMS find_package pkg_config embedding)
  psr_add_package_test(
    PackageConsumer.${psr_case} packages ${CMAKE_COMMAND} -D "PREFIX=${psr_prefix}" -D
    "LIBDIR=${CMAKE_INSTALL_LIBDIR}" -D "PROJECT_DIR=${PROJECT_SOURCE_DIR}" -D
    "SCRATCH=${PROJECT_BINARY_DIR}/test/consumer_${psr_case}" -D
    "GENERATOR=${CMAKE_GENERATOR}" -D "C_COMPILER=${CMAKE_C_COMPILER}" -D
    "CXX_COMPILER=${CMAKE_CXX_COMPILER}" -D "CXX_FLAGS=${CMAKE_CXX_FLAGS}" -D
    "LAUNCHER=${psr_consumer_launcher}" -P
    "${CMAKE_CURRENT_SOURCE_DIR}/consumer/${psr_case}.cmake")
endforeach()
