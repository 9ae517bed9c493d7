// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: options of pictures.
#pragma once

#include "cli/command_line.h"
#include "render/inspection_pictures.h"
#include "render/render_settings.h"

#include <string>

namespace app {

/** \brief Add the options that say how the picture is taken. */
void
addRenderOptions(CommandLine& command_line, RenderSettings& settings);

/** \brief Add --size, --view and --view-up of pictures whose view is chosen unless it
 * is given. */
void
addViewOptions(CommandLine& command_line, InspectionView& view);

/** \brief Fails for a name of a picture that does not end in .png. */
void
checkPictureName(const std::string& name);

} // namespace app
