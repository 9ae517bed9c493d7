// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the options of pcl_render_mesh.
#pragma once

#include "common/cli.h"
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

/** \brief Read X,Y,Z of an option that was given; fails for zero. */
Status
readDirection(const Arguments& arguments,
              const std::string& option,
              Eigen::Vector3d& direction);

} // namespace app
