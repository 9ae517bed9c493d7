// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what of the patches covers a crumb.

#pragma once

#include "patch/growing_surface.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace pcl::repair {

/** \brief The triangles of patches that are nearest to a crumb's corners and centres,
 * on the side that it shows. */
struct CrumbShadow {
  bool turned = false;                /**< it shows its other side */
  std::vector<std::size_t> triangles; /**< of the surface, ascending */
  std::size_t nearest = 0;            /**< of them */
  double distance = std::numeric_limits<double>::infinity(); /**< of that one */
  double ahead = 0.0; /**< cosine between the way there and its normal, unsigned */
  int slopes = 1;     /**< edges of the nearest between it and the crumb, 16 at most */
};

/** \brief The shadows of both sides of a crumb, as far as there are any, in the order
 * in which they are to be tried: which side small islands show is not sure.
 * \param[in] reach of the shadows, in units of the cloud */
std::vector<CrumbShadow>
shadowsOf(const std::vector<std::size_t>& crumb,
          double reach,
          const GrowingSurface& surface,
          ccaa::RunControl* control = nullptr);

} // namespace pcl::repair
