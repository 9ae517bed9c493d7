// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the options of pcl_render_mesh.
#pragma once

#include "common/cli.h"
#include "render/render_settings.h"

namespace app {

/** \brief Add the options that say how the picture is taken. */
void
addRenderOptions(CommandLine& command_line);

/** \brief Turn \a arguments into \a settings, or say which value is no use. */
Status
readRenderSettings(const Arguments& arguments, RenderSettings& settings);

} // namespace app
