# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: tests of the programs' manual pages and completions.

get_property(psr_programs GLOBAL PROPERTY PSR_PROGRAMS)
foreach(psr_program IN LISTS psr_programs)
  foreach(psr_case IN ITEMS man_options man_warnings completion_options choices)
    add_test(
      NAME PackagePages.${psr_program}_${psr_case}
      COMMAND
        bash "${CMAKE_CURRENT_SOURCE_DIR}/package/program_pages_test.sh" ${psr_case}
        $<TARGET_FILE:${psr_program}> "${PROJECT_BINARY_DIR}/programs")
  endforeach()
endforeach()
if(psr_programs AND TARGET app_viewer)
  add_test(NAME PackagePages.options_page_tells_when
           COMMAND bash "${PROJECT_SOURCE_DIR}/scripts/make_options.sh" --check
                   "${CMAKE_RUNTIME_OUTPUT_DIRECTORY}")
  add_test(NAME Documentation.GalleryEndsAsThePageSays
           COMMAND bash "${PROJECT_SOURCE_DIR}/scripts/make_gallery.sh" --check
                   "${CMAKE_RUNTIME_OUTPUT_DIRECTORY}")
endif()
if(psr_programs)
  add_test(
    NAME PackagePages.completion_offers_what_fits
    COMMAND bash "${CMAKE_CURRENT_SOURCE_DIR}/package/completion_test.sh"
            "${PROJECT_BINARY_DIR}/programs/completion")
endif()
