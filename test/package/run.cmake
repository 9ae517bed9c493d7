# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: runs a command or ends the script.

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "failed (${result}): ${command}")
  endif()
endfunction()
