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
# The dialog that asks for a file. Not required: without it files are named as arguments.
psr_find_quietly(Qt6 QUIET COMPONENTS Widgets)
if(NOT TARGET Qt6::Widgets)
  psr_find_quietly(Qt5 QUIET COMPONENTS Widgets)
endif()
foreach(psr_qt IN ITEMS Qt6::Widgets Qt5::Widgets)
  if(TARGET ${psr_qt})
    target_link_libraries(app_viewer PRIVATE ${psr_qt})
    target_compile_definitions(app_viewer PRIVATE PSR_HAS_QT)
    break()
  endif()
endforeach()
psr_unite_folders(app_viewer)
vtk_module_autoinit(TARGETS app_viewer MODULES VTK::InteractionStyle
                    VTK::RenderingContextOpenGL2 VTK::RenderingUI)
