// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the options of pcl_render_mesh.
#pragma once

#include "cli/cli.h"
#include "render/inspection_pictures.h"
#include "render/render_settings.h"

#include <string>

namespace app {

/** \brief Add the options that say how the picture is taken. */
void
addRenderOptions(CommandLine& command_line);

/** \brief Turn \a arguments into \a settings, or say which value is no use. */
Status
readRenderSettings(const Arguments& arguments, RenderSettings& settings);

/** \brief Read --size, which was given or has a default: WxH in pixels. */
Status
readSize(const Arguments& arguments, int& width, int& height);

/** \brief Add --size, --view and --view-up of pictures whose view is chosen unless it
 * is given. */
void
addViewOptions(CommandLine& command_line, const char* default_size);

/** \brief Turn them into \a view, or say which value is no use. */
Status
readView(const Arguments& arguments, InspectionView& view);

/** \brief Read X,Y,Z of an option that was given; fails for zero. */
Status
readDirection(const Arguments& arguments,
              const std::string& option,
              Eigen::Vector3d& direction);

} // namespace app
