# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: what draws the programs' pictures, with VTK and X.

psr_find_quietly(X11 REQUIRED QUIET)
psr_find_quietly(
  VTK
  REQUIRED
  QUIET
  COMPONENTS
  CommonCore
  CommonDataModel
  FiltersCore
  IOImage
  RenderingCore
  RenderingFreeType
  RenderingOpenGL2)
file(GLOB psr_render_sources CONFIGURE_DEPENDS
     "${CMAKE_CURRENT_SOURCE_DIR}/render/*.cpp"
     "${CMAKE_CURRENT_SOURCE_DIR}/render/*.h")
add_library(app_render STATIC ${psr_render_sources})
target_link_libraries(
  app_render
  PUBLIC app_common
         VTK::CommonCore
         VTK::CommonDataModel
         VTK::FiltersCore
         VTK::IOImage
         VTK::RenderingCore
         VTK::RenderingFreeType
         VTK::RenderingOpenGL2
         X11::X11
  PRIVATE psr_warnings)
set_target_properties(app_render PROPERTIES LINKER_LANGUAGE CXX)
# X11 has macros for words such as None.
set_source_files_properties("${CMAKE_CURRENT_SOURCE_DIR}/render/display.cpp"
                            PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
psr_unite_folders(app_render)
vtk_module_autoinit(TARGETS app_render MODULES VTK::RenderingFreeType
                    VTK::RenderingOpenGL2)
