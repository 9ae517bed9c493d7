# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: what only pcl_render_mesh needs, VTK and X.

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
  RenderingOpenGL2)
file(GLOB psr_render_sources CONFIGURE_DEPENDS
     "${PROJECT_SOURCE_DIR}/apps/render/*.cpp"
     "${PROJECT_SOURCE_DIR}/apps/render/*.h")
target_sources(pcl_render_mesh PRIVATE ${psr_render_sources})
target_link_libraries(
  pcl_render_mesh PRIVATE VTK::CommonCore VTK::CommonDataModel VTK::FiltersCore
                          VTK::IOImage VTK::RenderingCore VTK::RenderingOpenGL2 X11::X11)
vtk_module_autoinit(TARGETS pcl_render_mesh MODULES VTK::RenderingOpenGL2)
