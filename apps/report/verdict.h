// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the line in which a run says how it went.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace pcl {
struct RepairReport;
}

namespace app {

/** \brief What the verdict tells of a surface; what is not known is left out. */
struct SurfaceFacts {
  bool has_triangles = true;
  std::size_t left_open = 0; /**< boundaries that should have been closed */
  std::string reasons;       /**< for these, such as "2 INTERSECTION, 1 UNDECIDED" */
  std::string doubts;        /**< such as "1 TUNNEL" */
  std::size_t borders = 0;   /**< that may stay open */
  std::size_t open = 0;      /**< boundaries of which nobody asked whether they may */
  std::size_t faults = 0;    /**< places where it is no surface */
  std::optional<std::size_t> pieces;
};

/** \brief Such as "watertight, 1 piece" or "2 borders open, 1 piece". */
std::string
tellSurface(const SurfaceFacts& facts);

/** \brief The facts that a repair tells of its result. */
SurfaceFacts
surfaceFacts(const pcl::RepairReport& report);

} // namespace app
