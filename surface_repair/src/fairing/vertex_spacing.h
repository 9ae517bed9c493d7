// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: new vertices spread evenly within the surface of a patch.

#pragma once

#include "filling/patch.h"
#include "run/run_control.h"

#include <cstddef>
#include <vector>

namespace pcl::repair {

/** \brief Cosine between normals of triangles of one plane. */
constexpr double ONE_PLANE = 1.0 - 1e-12;

/** \brief Move vertices within their tangent planes towards the centroids of their
 * triangles, one after the other, where no triangle turns over by it.
 *
 * \param[in] first the vertices from this one on may move
 * \param[in] lengths wanted at the vertices: where they are short triangles weigh more
 * \param[in] keeps_shape only vertices all around which the triangles lie in one plane
 */
void
spaceVertices(std::size_t first,
              const std::vector<double>& lengths,
              Patch& patch,
              bool keeps_shape = false,
              ccaa::RunControl* control = nullptr);

} // namespace pcl::repair
