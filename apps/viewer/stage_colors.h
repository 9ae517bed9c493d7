// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: colours of the viewer that inspections do not have.
#pragma once

#include <pcl/surface_repair/repair_report.h>

#include "inspect/inspection_colors.h"

namespace app {

constexpr Rgb ADDED_TEAL{70, 175, 175};      /**< by the base algorithm */
constexpr Rgb CHOSEN{255, 215, 0};           /**< what is being decided about */
constexpr Rgb TO_BE_CLOSED{0, 150, 70};      /**< loops that a user wants closed */
constexpr Rgb OVERFULL_MAGENTA{215, 0, 215}; /**< edges of three or more triangles */
constexpr Rgb RAW_BACK{208, 200, 190};       /**< of triangles not yet wound alike */
constexpr Rgb REMOVED_CORAL{235, 110, 80};   /**< by the filter */
constexpr Rgb ROLE_INTERNAL{120, 135, 150};
constexpr Rgb ROLE_BOUNDARY{215, 25, 30};

/** \brief Of new triangles, and of the hole that they close. */
Rgb
colorOf(pcl::TriangleOrigin origin);

/** \brief Of a boundary that stays open: that of an outer border, else warm colours. */
Rgb
colorOf(pcl::OpenReason reason);

} // namespace app
