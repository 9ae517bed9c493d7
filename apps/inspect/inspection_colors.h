// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the colours in which an incomplete model is shown.
#pragma once

#include "boundary/classification.h"
#include "force_line/force_line.h"
#include "orientation/island_orientation.h"

#include <array>
#include <cstdint>

namespace app {

/** \brief Red, green, blue, 0 to 255. */
using Rgb = std::array<std::uint8_t, 3>;

constexpr Rgb BOUNDARY_GREY{70, 70, 75};
constexpr Rgb SECTION_BLACK{20, 20, 25};
constexpr Rgb NORMAL_BLUE{110, 150, 235};
constexpr Rgb FREE_POINT_VIOLET{120, 40, 170};

Rgb
colorOf(pcl::repair::BoundaryClass boundary_class);

/** \brief A light colour a rule; darker for islands that were turned round. */
Rgb
colorOf(const pcl::repair::IslandSide& side);

/** \brief The colour of lines with this end; for bridges that of the weakest. */
Rgb
colorOf(pcl::repair::LineEnd end);

/** \brief From the weakest bridge, at 0, to the strongest, at 1. */
Rgb
colorOfBridge(double strength);

/** \brief From no tension, at 0: white, over yellow and red to nearly black at 1. */
Rgb
colorOfTension(double share);

} // namespace app
