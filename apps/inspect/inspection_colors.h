// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the colours in which an incomplete model is shown.
#pragma once

#include <pcl/surface_repair/repair_report.h>

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
constexpr Rgb ADDED_TEAL{70, 175, 175};      /**< by the base algorithm */
constexpr Rgb CHOSEN{255, 215, 0};           /**< what is being decided about */
constexpr Rgb TO_BE_CLOSED{0, 150, 70};      /**< loops that a user wants closed */
constexpr Rgb OVERFULL_MAGENTA{215, 0, 215}; /**< edges of three or more triangles */
constexpr Rgb RAW_BACK{208, 200, 190};       /**< of triangles not yet wound alike */
constexpr Rgb REMOVED_CORAL{235, 110, 80};   /**< by the filter */
constexpr Rgb ROLE_INTERNAL{120, 135, 150};
constexpr Rgb ROLE_BOUNDARY{215, 25, 30};

Rgb
colorOf(pcl::repair::BoundaryClass boundary_class);

/** \brief A light colour a rule; darker for islands that were turned round. */
Rgb
colorOf(const pcl::repair::IslandSide& side);

/** \brief The colour of lines with this end; for bridges that of the weakest. */
Rgb
colorOf(pcl::repair::LineEnd end);

/** \brief Of new triangles, and of the hole that they close. */
Rgb
colorOf(pcl::TriangleOrigin origin);

/** \brief Of a boundary that stays open: that of an outer border, else warm colours. */
Rgb
colorOf(pcl::OpenReason reason);

/** \brief From the weakest bridge, at 0, to the strongest, at 1. */
Rgb
colorOfBridge(double strength);

/** \brief From no tension, at 0: white, over yellow and red to nearly black at 1. */
Rgb
colorOfTension(double share);

} // namespace app
