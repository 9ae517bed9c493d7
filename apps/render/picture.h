// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: draws a mesh off-screen.
#pragma once

#include "render/mesh_parts.h"
#include "render/render_settings.h"

#include <string>

namespace app {

/** \brief Draw \a parts off-screen and return the picture as the bytes of a PNG file;
 * empty when no picture could be taken. Needs an X display (see display.h). */
std::string
drawPng(const MeshParts& parts, const RenderSettings& settings);

} // namespace app
