// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: lays a crumb into the patch that covers it.

#pragma once

#include "pass/passes.h"
#include "patch/growing_surface.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace pcl::repair {

/** \brief What becomes of a crumb. */
struct LaidCrumb {
  std::optional<Replacement> ring;       /**< if it could be laid: what closes it */
  std::map<std::size_t, Triangle> crumb; /**< its triangles then */
  std::size_t hole = NONE;               /**< that the ring is part of */
  ccaa::Box seen;                        /**< all that it depends on */
  std::uint64_t work = 0;
};

/** \brief Open the patch around the shadow of a crumb, its nearest triangles on the
 * side that it shows, and close the ring between opening and crumb. Where both have a
 * point of the cloud it becomes one vertex. A crumb that shows the other side
 * everywhere is turned.
 *
 * It cannot be laid where no patch lies near, or where every filling runs into
 * something. Cost: some ms. \param[in] crumb triangles of a disc, ascending
 * \param[in] edge mean length of edges: a tiny triangle may lie that far from a patch
 * \param[in,out] run told the work, may be null */
LaidCrumb
layCrumb(const std::vector<std::size_t>& crumb,
         double edge,
         const Course& course,
         ccaa::RunControl* run,
         const GrowingSurface& surface);

} // namespace pcl::repair
