// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what is tried, one after the other, to fill a hole.

#pragma once

#include <array>
#include <cstddef>

namespace pcl {
namespace repair {

/** \brief A way to fill a hole. */
struct FillStrategy {
  const char* name;
  bool avoids;       /**< the fill may not run through anything; expensive */
  bool refined;      /**< to the density of the surface around */
  bool relaxed;      /**< faired; only when refined */
  bool without_free; /**< free points do not become vertices */
};

/** \brief Each is tried when all before have failed; those without free points only
 * where free points did become vertices. */
constexpr std::array<FillStrategy, 8> FILL_STRATEGIES = {
    {{"plain", false, true, true, false},
     {"around obstacles", true, true, true, false},
     {"unrelaxed", false, true, false, false},
     {"around obstacles, unrelaxed", true, true, false, false},
     {"around obstacles, bare", true, false, false, false},
     {"around obstacles, without free points", true, true, true, true},
     {"around obstacles, unrelaxed, without free points", true, true, false, true},
     {"around obstacles, bare, without free points", true, false, false, true}}};

/** \brief So many of them for a hole that has others in its region: it is alone in the
 * next pass. */
constexpr std::size_t STRATEGIES_AMONG_OTHERS = 1;

/** \brief No strategy is left. */
constexpr std::size_t GIVEN_UP = FILL_STRATEGIES.size();

} // namespace repair
} // namespace pcl
