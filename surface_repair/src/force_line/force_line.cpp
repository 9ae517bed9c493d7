// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a force line of the indicator field (4.41).

#include "force_line/force_line.h"

namespace pcl::repair {

const char*
describe(LineEnd end)
{
  switch (end) {
  case LineEnd::BRIDGE:
    return "reached another boundary";
  case LineEnd::REPELLED:
    return "repelled at its origin";
  case LineEnd::NO_FIELD:
    return "no field at its origin";
  case LineEnd::OUT_OF_REACH:
    return "left the reach of its targets";
  case LineEnd::TOO_LONG:
    return "too long for the gap";
  case LineEnd::CROSSES_SURFACE:
    return "crosses the surface";
  case LineEnd::WRONG_SIDE:
    return "came to the wrong side of the other boundary";
  }
  return "unknown";
}

} // namespace pcl::repair
