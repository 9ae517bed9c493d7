// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the coarse patch of a region grows over its samples.

#include "region/patch_growth.h"

#include "fairing/crossing_flips.h"
#include "fairing/sample_growth.h"
#include "region/patch_mending.h"
#include "region/sample_evidence.h"

#include <utility>

namespace pcl::repair {

bool
growPatch(const ClosingPlace& place,
          const std::vector<std::size_t>& samples,
          const SurfaceObstacle& obstacle,
          const ccaa::LoopContext& context,
          Patch& patch)
{
  const auto is_obstructed = [&](const ccaa::Corners& corners) {
    return obstacle.meets(corners, context.control);
  };
  std::vector<std::size_t> crossing;
  if (place.mends && patch.creases.empty()) // which mending does not know
    crossing = obstructedTriangles(patch, obstacle, context.control);
  // A patch with a handle is wrong as a whole.
  if (!crossing.empty() && surfaceKindOf(patch).genus == 0) {
    flipCrossings(
        place.model, std::move(crossing), is_obstructed, patch, context.control);
    mendPatch(place, obstacle, context, patch);
  }
  growOver(place.model, samples, is_obstructed, patch, context.control);
  return samplesDescribe(place.model.free_points, samples, patch);
}

} // namespace pcl::repair
