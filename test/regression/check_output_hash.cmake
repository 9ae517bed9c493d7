# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: makes one output and compares its hash with the table's.
#
# cmake -D APPS_DIR= -D SCRATCH= -D INPUT= -D DAMAGE= -D PROGRAM= -D OPTIONS= -D NAME=
#       [-D EXPECTED=] [-D SKIP=reason] -P check_output_hash.cmake
# Without EXPECTED it prints the hash.

# Exit code 2 tells that something was left open, which is a result as well.
function(run)
  execute_process(
    COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE reason)
  if(NOT result EQUAL 0 AND NOT result EQUAL 2)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "failed (${result}): ${command}\n${reason}")
  endif()
endfunction()

if(SKIP)
  message("skipped: ${SKIP}")
  return()
endif()
if(NOT EXISTS "${INPUT}")
  message("skipped: there is no '${INPUT}'")
  return()
endif()
file(MAKE_DIRECTORY "${SCRATCH}")
set(output "${SCRATCH}/${NAME}.ply")
separate_arguments(damage UNIX_COMMAND "${DAMAGE}")
separate_arguments(options UNIX_COMMAND "${OPTIONS}")
if(damage)
  run("${APPS_DIR}/pcl_damage_cloud" "${INPUT}" "${SCRATCH}/${NAME}_damaged.ply"
      ${damage} --quiet)
  set(INPUT "${SCRATCH}/${NAME}_damaged.ply")
endif()
run("${APPS_DIR}/${PROGRAM}" "${INPUT}" "${output}" ${options} --quiet)
file(SHA256 "${output}" actual)
if(NOT EXPECTED)
  message("${actual}")
elseif(NOT actual STREQUAL EXPECTED)
  message(
    FATAL_ERROR
      "the result of ${NAME} has changed: ${output}\n"
      "  expected ${EXPECTED}\n  actual   ${actual}\n"
      "If it is meant to: look at it, run scripts/update_output_hashes.sh, and say why.")
endif()
