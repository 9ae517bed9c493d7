// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what is tried, one after the other, to fill a hole.

#pragma once

#include <array>
#include <cstddef>

namespace pcl::repair {

/** \brief A way to fill a hole. */
struct FillStrategy {
  bool avoids;      /**< the fill may not run through anything; expensive */
  bool keeps_shape; /**< refined within its triangles, and relaxed no further than there
                       is room: a fill that is free stays free */
  bool without_free; /**< free points do not become vertices */
};

constexpr FillStrategy PLAIN = {false, false, false};
constexpr FillStrategy PLAIN_KEEPING = {false, true, false};
constexpr FillStrategy AVOIDING = {true, false, false};
constexpr FillStrategy AVOIDING_KEEPING = {true, true, false};

/** \brief The same, but free points do not become vertices. */
constexpr FillStrategy
withoutFreePoints(FillStrategy strategy)
{
  strategy.without_free = true;
  return strategy;
}

/** \brief Each is tried when all before have failed; those without free points only
 * where free points did become vertices. */
constexpr std::array<FillStrategy, 6> FILL_STRATEGIES = {
    {PLAIN,
     PLAIN_KEEPING,
     AVOIDING,
     AVOIDING_KEEPING,
     withoutFreePoints(AVOIDING),
     withoutFreePoints(AVOIDING_KEEPING)}};

/** \brief So many of them for a hole that has others in its region: it is alone in the
 * next pass. One more where samples tell the shape that is kept. */
constexpr std::size_t STRATEGIES_AMONG_OTHERS = 1;

/** \brief No strategy is left. */
constexpr std::size_t GIVEN_UP = FILL_STRATEGIES.size();

} // namespace pcl::repair
