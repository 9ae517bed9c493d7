// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: colours of the viewer that inspections do not have.
#include "viewer/stage_colors.h"

namespace app {

using pcl::OpenReason;
using pcl::TriangleOrigin;

Rgb
colorOf(TriangleOrigin origin)
{
  switch (origin) {
  case TriangleOrigin::INPUT:
    break;
  case TriangleOrigin::FAN:
    return {235, 170, 50};
  case TriangleOrigin::MINIMUM_WEIGHT:
    return {60, 140, 225};
  case TriangleOrigin::COMPLETION:
    return {185, 105, 215};
  }
  return {225, 225, 220};
}

Rgb
colorOf(OpenReason reason)
{
  switch (reason) {
  case OpenReason::NONE:
    break;
  case OpenReason::OUTER_BORDER:
    return colorOf(pcl::repair::BoundaryClass::OUTER_BORDER);
  case OpenReason::TUBE_MOUTH:
    return {0, 115, 115};
  case OpenReason::DIFFERENT_OBJECTS:
    return {90, 110, 140};
  case OpenReason::DEPTH_JUMP:
    return {75, 190, 150};
  case OpenReason::SEEN_EMPTY:
    return {60, 150, 190};
  case OpenReason::NOT_JOINED:
    return {160, 85, 20};
  case OpenReason::UNDECIDED:
    return colorOf(pcl::repair::BoundaryClass::UNDECIDED);
  case OpenReason::ONE_SIDED:
    return {215, 120, 230};
  case OpenReason::TOO_LARGE:
    return {130, 0, 20};
  case OpenReason::NO_DARN:
    return {215, 25, 30};
  case OpenReason::NOT_MANIFOLD:
    return {255, 100, 90};
  case OpenReason::INTERSECTION:
    return {235, 0, 130};
  case OpenReason::NOT_WANTED:
    return {110, 110, 110};
  }
  return colorOf(TriangleOrigin::MINIMUM_WEIGHT);
}

} // namespace app
