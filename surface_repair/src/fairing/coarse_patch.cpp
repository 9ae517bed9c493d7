// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a patch of few triangles, which are looked through one by
// one.

#include "fairing/coarse_patch.h"

#include "mesh/intersection.h"

#include <algorithm>

namespace pcl::repair {

namespace {

/** Boxes that are looked at in an operation. */
constexpr std::size_t BOXES_AT_ONCE = 4;

} // namespace

CoarsePatch::CoarsePatch(const IncompleteModel& model,
                         const std::function<bool(const ccaa::Corners&)>& obstructed,
                         Patch& whole,
                         ccaa::RunControl* run)
: patch(whole)
, control(run)
, edges(model, whole)
, bending(model, whole, edges)
, obstructed_(obstructed)
{
  for (std::size_t triangle = 0; triangle < whole.triangles.size(); ++triangle)
    note(triangle);
}

void
CoarsePatch::note(std::size_t triangle)
{
  boxes.resize(std::max(boxes.size(), triangle + 1));
  boxes[triangle] = ccaa::boxOf(cornersAt(triangle));
  bending.note(triangle);
}

std::size_t
CoarsePatch::flip(std::size_t side)
{
  const std::size_t beyond = edges.across(side) / 3;
  edges.flip(side);
  note(side / 3);
  note(beyond);
  return beyond;
}

bool
CoarsePatch::canFlip(std::size_t side) const
{
  const auto [a, b, c, d] = edges.pairAt(side);
  return c != d && !edges.areJoined(c, d) && !edges.areJoinedInModel(c, d) &&
         !ccaa::isCollinear({at(d), at(c), at(a)}) &&
         !ccaa::isCollinear({at(d), at(c), at(b)});
}

std::size_t
CoarsePatch::meetings(const ccaa::Corners& corners,
                      const std::vector<std::size_t>& old,
                      std::size_t enough) const
{
  if (!ccaa::spend(control, boxes.size() / BOXES_AT_ONCE))
    return enough;
  const ccaa::Box box = ccaa::boxOf(corners);
  std::size_t count = 0;
  for (std::size_t t = 0; t < boxes.size() && count < enough; ++t)
    if (boxes[t].intersects(box) && std::find(old.begin(), old.end(), t) == old.end() &&
        ccaa::areasMeet(corners, cornersAt(t)))
      ++count;
  return count < enough && obstructed_(corners) ? count + 1 : count;
}

} // namespace pcl::repair
