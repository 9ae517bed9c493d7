# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: the Python package pclsurfacerepair, whole in build/.../python.

if(NOT PSR_BUILD_PYTHON)
  return()
endif()
# Debian's pybind11 and numpy are those of its own Python, whatever else is in the path.
if(EXISTS "/etc/debian_version" AND NOT DEFINED Python_EXECUTABLE)
  find_program(Python_EXECUTABLE python3 PATHS /usr/bin NO_DEFAULT_PATH)
endif()
find_package(Python 3.11 QUIET COMPONENTS Interpreter Development.Module)
find_package(pybind11 2.9 CONFIG QUIET)
if(NOT Python_FOUND OR NOT pybind11_FOUND)
  set(psr_level STATUS)
  if(PSR_BUILD_PYTHON STREQUAL "REQUIRED")
    set(psr_level FATAL_ERROR)
  endif()
  message(${psr_level} "No pybind11 or no headers of Python 3.11 or later: the Python "
          "package is left out")
  return()
endif()
# For the tests and the package, in folders of their own.
set(PSR_PYTHON "${Python_EXECUTABLE}" CACHE INTERNAL "")
set(PSR_PYTHON_MINOR "${Python_VERSION_MINOR}" CACHE INTERNAL "")

set(psr_python_source "${CMAKE_CURRENT_SOURCE_DIR}/python")
set(psr_python_build "${PROJECT_BINARY_DIR}/python/pclsurfacerepair")
set(psr_options_header "${CMAKE_CURRENT_BINARY_DIR}/python/generated_options.h")
file(GLOB psr_option_headers CONFIGURE_DEPENDS
     "${PROJECT_SOURCE_DIR}/surface_ccaa/include/pcl/surface_ccaa/*.h"
     "${PROJECT_SOURCE_DIR}/surface_repair/include/pcl/surface_repair/*.h"
     "${CMAKE_CURRENT_SOURCE_DIR}/clean/*.h")
add_custom_command(
  OUTPUT "${psr_options_header}" "${psr_python_build}/_options.py"
  COMMAND
    Python::Interpreter "${psr_python_source}/generate_options.py"
    "${PROJECT_SOURCE_DIR}/surface_ccaa/include/pcl/surface_ccaa"
    "${PROJECT_SOURCE_DIR}/surface_repair/include/pcl/surface_repair"
    "${CMAKE_CURRENT_SOURCE_DIR}/clean" --cpp
    "${psr_options_header}" --python "${psr_python_build}/_options.py"
  DEPENDS "${psr_python_source}/generate_options.py" ${psr_option_headers}
  VERBATIM)

# What is written in Python lies beside the module, so that tests and users see the same.
file(GLOB psr_python_files CONFIGURE_DEPENDS "${psr_python_source}/pclsurfacerepair/*")
foreach(psr_python_file IN LISTS psr_python_files)
  get_filename_component(psr_python_name "${psr_python_file}" NAME)
  configure_file("${psr_python_file}" "${psr_python_build}/${psr_python_name}" COPYONLY)
endforeach()

file(GLOB psr_python_sources CONFIGURE_DEPENDS "${psr_python_source}/*.cpp"
     "${psr_python_source}/*.h")
pybind11_add_module(pclsurfacerepair_python MODULE NO_EXTRAS ${psr_python_sources}
                    "${psr_options_header}")
target_include_directories(pclsurfacerepair_python
                           PRIVATE "${CMAKE_CURRENT_BINARY_DIR}/python")
target_link_libraries(pclsurfacerepair_python PRIVATE app_common psr_warnings
                                                      psr_link_options)
set_target_properties(
  pclsurfacerepair_python
  PROPERTIES OUTPUT_NAME _core
             LIBRARY_OUTPUT_DIRECTORY "${psr_python_build}"
             INSTALL_RPATH "$ORIGIN/../../../../${CMAKE_INSTALL_LIBDIR}")
psr_unite_folders(pclsurfacerepair_python)
set_target_properties(app_common PROPERTIES POSITION_INDEPENDENT_CODE ON)

# Below a wheel's root the package lies as it is; Debian has a place of its own for it.
set(PSR_PYTHON_INSTALL_DIR "lib/python3/dist-packages"
    CACHE PATH "Folder of Python packages below the prefix")
install(
  DIRECTORY "${psr_python_build}"
  DESTINATION "${PSR_PYTHON_INSTALL_DIR}"
  COMPONENT python
  PATTERN "__pycache__" EXCLUDE
  PATTERN "_core.*.so" EXCLUDE)
install(TARGETS pclsurfacerepair_python
        LIBRARY DESTINATION "${PSR_PYTHON_INSTALL_DIR}/pclsurfacerepair" COMPONENT python)
