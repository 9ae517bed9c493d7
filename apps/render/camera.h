// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: points the camera at an object.
#pragma once

#include "render/render_settings.h"

#include <vector>

class vtkCamera;

namespace app {

/** \brief Aim \a camera so that \a positions fill the picture at zoom 1, without
 * perspective: parallel lines stay parallel, so angles can be judged by eye. */
void
aimCamera(const std::vector<Eigen::Vector3d>& positions,
          const RenderSettings& settings,
          vtkCamera& camera);

} // namespace app
