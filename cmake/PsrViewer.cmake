# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: the window of pcl_repair_viewer, with PCL's visualization.

psr_find_quietly(
  VTK
  REQUIRED
  QUIET
  COMPONENTS
  CommonCore
  InteractionStyle
  RenderingContextOpenGL2
  RenderingUI)
file(GLOB psr_viewer_sources CONFIGURE_DEPENDS
     "${CMAKE_CURRENT_SOURCE_DIR}/viewer/*.cpp"
     "${CMAKE_CURRENT_SOURCE_DIR}/viewer/*.h")
add_library(app_viewer STATIC ${psr_viewer_sources})
target_link_libraries(
  app_viewer
  PUBLIC app_render pcl_visualization VTK::InteractionStyle
         VTK::RenderingContextOpenGL2 VTK::RenderingUI
  PRIVATE psr_warnings)
set_target_properties(app_viewer PROPERTIES LINKER_LANGUAGE CXX)
# PCL's header of a header complains that its name is another one now.
target_compile_definitions(
  app_viewer PRIVATE BOOST_BIND_GLOBAL_PLACEHOLDERS BOOST_ALLOW_DEPRECATED_HEADERS)
vtk_module_autoinit(TARGETS app_viewer MODULES VTK::InteractionStyle
                    VTK::RenderingContextOpenGL2 VTK::RenderingUI)
