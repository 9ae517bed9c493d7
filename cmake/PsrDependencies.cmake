# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: the packages every part of the build needs.

# PCL's configuration prints a line per component even when told to be quiet.
macro(psr_find_quietly)
  set(psr_log_level_before "${CMAKE_MESSAGE_LOG_LEVEL}")
  set(CMAKE_MESSAGE_LOG_LEVEL WARNING)
  find_package(${ARGN})
  set(CMAKE_MESSAGE_LOG_LEVEL "${psr_log_level_before}")
endmacro()

set(PSR_PCL_MINIMUM 1.12)
set(PSR_PCL_COMPONENTS common search kdtree surface)
psr_find_quietly(PCL ${PSR_PCL_MINIMUM} REQUIRED QUIET COMPONENTS ${PSR_PCL_COMPONENTS})
psr_find_quietly(OpenMP REQUIRED QUIET COMPONENTS CXX)
message(STATUS "PCL ${PCL_VERSION}, OpenMP ${OpenMP_CXX_VERSION}")
