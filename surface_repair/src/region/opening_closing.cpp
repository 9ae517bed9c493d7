// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: an opening is closed as a hole of its own.

#include "region/opening_closing.h"

#include "boundary/extraction.h"
#include "region/region_closing.h"

namespace pcl::repair {

HoleOutcome
closeOpening(const Opening& opening,
             const ModelPart& part,
             const ccaa::Box& around,
             const RepairParameters& parameters,
             const CloudFrame& frame,
             const ccaa::LoopContext& context,
             std::size_t of_hole,
             GrowingSurface& surface)
{
  HoleOutcome outcome;
  outcome.open = OpenReason::INTERSECTION;
  if (opening.border.empty() || !isWithin(around, part, opening))
    return outcome;
  const ccaa::Box box = placeOf(part, opening).intersection(around);
  const ModelPart left =
      surface.part(trianglesLeft(part, opening, box), context.control);
  if (context.cancelled())
    return outcome;
  const BoundaryLoops loops = extractBoundaries(left.model);
  const BoundaryLoop* loop = loopOf(opening, part, left, loops);
  if (loop == nullptr)
    return outcome;
  Region region;
  region.holes.push_back(polygonOf(*loop));
  region.is_certain.push_back(true);
  const SurfaceObstacle obstacle(left.model, {box}, context.threads, context.control);
  const ClosedRegion closed =
      closeRegion(withinPart(left.model, parameters, frame), region, obstacle, context);
  if (closed.holes.front().open == OpenReason::NONE &&
      !isFree(closed.patch, box, obstacle, context.control))
    return outcome;
  outcome = closed.holes.front();
  if (outcome.open == OpenReason::NONE)
    surface.replace(part, opening.is_open, left, closed.patch, of_hole);
  return outcome;
}

} // namespace pcl::repair
