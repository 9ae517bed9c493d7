// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what is tried, one after the other, to fill a hole.

#pragma once

#include <array>
#include <cstddef>

namespace pcl {
namespace repair {

/** \brief A way to fill a hole. */
struct FillStrategy {
  bool avoids;       /**< the fill may not run through anything; expensive */
  bool refined;      /**< to the density of the surface around */
  bool relaxed;      /**< faired; only when refined */
  bool without_free; /**< free points do not become vertices */
};

constexpr FillStrategy PLAIN = {false, true, true, false};
constexpr FillStrategy UNRELAXED = {false, true, false, false};
constexpr FillStrategy AVOIDING = {true, true, true, false};
constexpr FillStrategy AVOIDING_UNRELAXED = {true, true, false, false};
constexpr FillStrategy AVOIDING_BARE = {true, false, false, false};

/** \brief The same, but free points do not become vertices. */
constexpr FillStrategy
withoutFreePoints(FillStrategy strategy)
{
  strategy.without_free = true;
  return strategy;
}

/** \brief Each is tried when all before have failed; those without free points only
 * where free points did become vertices. */
constexpr std::array<FillStrategy, 8> FILL_STRATEGIES = {
    {PLAIN,
     AVOIDING,
     UNRELAXED,
     AVOIDING_UNRELAXED,
     AVOIDING_BARE,
     withoutFreePoints(AVOIDING),
     withoutFreePoints(AVOIDING_UNRELAXED),
     withoutFreePoints(AVOIDING_BARE)}};

/** \brief So many of them for a hole that has others in its region: it is alone in the
 * next pass. */
constexpr std::size_t STRATEGIES_AMONG_OTHERS = 1;

/** \brief No strategy is left. */
constexpr std::size_t GIVEN_UP = FILL_STRATEGIES.size();

} // namespace repair
} // namespace pcl
