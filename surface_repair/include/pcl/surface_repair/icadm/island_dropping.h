// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: leaves out islands that are too small to be wanted.

#pragma once

#include <pcl/surface_ccaa/mesh/block_loop.h>
#include <pcl/surface_repair/icadm/model_reading.h>

#include <cstddef>

namespace pcl {
namespace repair {

/** \brief Which islands are too small: those below any of the limits. */
struct SmallIslands {
  std::size_t triangles = 0;      /**< fewer than so many */
  double area = 0.0;              /**< less than that, squared units of the cloud */
  double share_of_all_area = 0.0; /**< less than that of all islands' area, 0 to 1 */

  bool
  any() const
  {
    return triangles > 0 || area > 0.0 || share_of_all_area > 0.0;
  }
};

/** \brief Take small islands out of a model. Their points are neither vertices nor free
 * points of it any more: they draw nothing. What is dropped is counted in the report;
 * where nothing is left, that is its problem. Cost: that of assembleModel() where
 * anything is dropped. */
void
dropIslands(const SmallIslands& small,
            const ccaa::LoopContext& context,
            ReadModel& read);

} // namespace repair
} // namespace pcl
