# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: tests of the pages and of the site that is made of them.

set(psr_doc_tests "${CMAKE_CURRENT_SOURCE_DIR}/documentation")
add_test(NAME Documentation.LinksLeadToFiles
         COMMAND bash "${psr_doc_tests}/links_test.sh" "${PROJECT_SOURCE_DIR}")
add_test(NAME Documentation.RoomsUseWhatTheLayoutAllows
         COMMAND bash "${psr_doc_tests}/rooms_test.sh" "${PROJECT_SOURCE_DIR}")
add_test(NAME Documentation.NotationNamesWhatIsInTheCode
         COMMAND bash "${psr_doc_tests}/notation_test.sh" names "${PROJECT_SOURCE_DIR}")
add_test(NAME Documentation.NotationHasEveryTagOfTheCode
         COMMAND bash "${psr_doc_tests}/notation_test.sh" tags "${PROJECT_SOURCE_DIR}")
find_program(PSR_PYTHON3 python3)
mark_as_advanced(PSR_PYTHON3)
if(PSR_PYTHON3)
  add_test(
    NAME Documentation.ConstantsHaveCommentsAndArePaged
    COMMAND "${PSR_PYTHON3}" "${PROJECT_SOURCE_DIR}/scripts/make_constants.py" --check)
endif()

# The packages hold the site, so it is built before them.
find_program(PSR_DOXYGEN doxygen)
mark_as_advanced(PSR_DOXYGEN)
if(PSR_DOXYGEN)
  add_test(NAME Documentation.SiteBuildsWithoutWarnings
           COMMAND bash "${PROJECT_SOURCE_DIR}/scripts/build_docs.sh")
  set_tests_properties(Documentation.SiteBuildsWithoutWarnings
                       PROPERTIES FIXTURES_SETUP documentation)
  find_program(PSR_NODE NAMES node nodejs)
  mark_as_advanced(PSR_NODE)
  if(PSR_NODE)
    add_test(NAME Documentation.SearchFindsWhatPagesSay
             COMMAND "${PSR_NODE}" "${psr_doc_tests}/search_test.js"
                     "${PROJECT_SOURCE_DIR}/build/docs/html")
    set_tests_properties(Documentation.SearchFindsWhatPagesSay
                         PROPERTIES FIXTURES_REQUIRED documentation)
  endif()
endif()
