# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: what lies in the system's own folders is found without a
# search path in the program. Run by CPack on the files before it packs them.

file(GLOB psr_staged "${CPACK_TEMPORARY_INSTALL_DIRECTORY}/*/usr/bin/*"
     "${CPACK_TEMPORARY_INSTALL_DIRECTORY}/*/usr/lib/*/*.so.*"
     "${CPACK_TEMPORARY_INSTALL_DIRECTORY}/*/usr/lib/python3/*/*/*.so")
foreach(psr_file IN LISTS psr_staged)
  if(NOT IS_SYMLINK "${psr_file}")
    file(RPATH_REMOVE FILE "${psr_file}")
  endif()
endforeach()
