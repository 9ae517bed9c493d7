// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: an opening is closed as a hole of its own.

#include "region/opening_closing.h"

#include "boundary/extraction.h"
#include "region/region_closing.h"

#include <utility>

namespace pcl::repair {

ClosedOpening
closeOpening(const Opening& opening,
             const ModelPart& part,
             const ccaa::Box& around,
             const RepairParameters& parameters,
             const CloudFrame& frame,
             const ccaa::LoopContext& context,
             const GrowingSurface& surface)
{
  ClosedOpening result;
  result.outcome.open = OpenReason::INTERSECTION;
  if (opening.border.empty() || !isWithin(around, part, opening))
    return result;
  const ccaa::Box box = placeOf(part, opening).intersection(around);
  const ModelPart left =
      surface.part(trianglesLeft(part, opening, box), context.control);
  if (context.cancelled())
    return result;
  const BoundaryLoops loops = extractBoundaries(left.model);
  const BoundaryLoop* loop = loopOf(opening, part, left, loops);
  if (loop == nullptr)
    return result;
  Region region;
  region.holes.push_back(polygonOf(*loop));
  region.is_certain.push_back(true);
  const SurfaceObstacle obstacle(left.model, {box}, context.threads, context.control);
  ClosedRegion closed =
      closeRegion(withinPart(left.model, parameters, frame), region, obstacle, context);
  if (closed.holes.front().open == OpenReason::NONE &&
      !isFree(closed.patch, box, obstacle, context.control))
    return result;
  result.outcome = closed.holes.front();
  if (result.outcome.open == OpenReason::NONE)
    result.replacement =
        replacementIn(part, opening.is_open, left, std::move(closed.patch));
  return result;
}

} // namespace pcl::repair
