# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: manual page and bash completion of each program, made from
# what the program itself says when it is asked for help.

set(psr_pages_dir "${PROJECT_BINARY_DIR}/programs")
file(MAKE_DIRECTORY "${psr_pages_dir}/man" "${psr_pages_dir}/completion")

# psr_add_program_pages(<programs>)
function(psr_add_program_pages)
  set_property(GLOBAL PROPERTY PSR_PROGRAMS ${ARGN})
  if(CMAKE_CROSSCOMPILING)
    return()
  endif()
  set(tools "${PROJECT_SOURCE_DIR}/cmake")
  foreach(program IN LISTS ARGN)
    set(page "${psr_pages_dir}/man/${program}.1.gz")
    set(completion "${psr_pages_dir}/completion/${program}")
    add_custom_command(
      OUTPUT "${page}"
      COMMAND "${tools}/make_man_page.sh" $<TARGET_FILE:${program}> "${page}" ${ARGN}
      DEPENDS ${program} "${tools}/make_man_page.sh" "${tools}/program_help.sh"
      VERBATIM)
    add_custom_command(
      OUTPUT "${completion}"
      COMMAND "${tools}/make_completion.sh" $<TARGET_FILE:${program}>
              "${tools}/psr_completion.bash" "${completion}"
      DEPENDS ${program} "${tools}/make_completion.sh" "${tools}/program_help.sh"
              "${tools}/psr_completion.bash"
      VERBATIM)
    list(APPEND pages "${page}")
    list(APPEND completions "${completion}")
  endforeach()
  add_custom_target(program_pages ALL DEPENDS ${pages} ${completions})
  add_dependencies(apps program_pages)
  install(FILES ${pages} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT tools)
  install(FILES ${completions}
          DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/bash-completion/completions
          COMPONENT tools)
endfunction()
