// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: edges of a coarse patch are flipped where it runs through
// itself.

#include "fairing/crossing_flips.h"

#include "fairing/coarse_patch.h"
#include "mesh/intersection.h"

#include <algorithm>
#include <limits>

namespace pcl::repair {

namespace {

/** Rounds over what runs into something. Three were the most that flipped anything. */
constexpr int MOST_ROUNDS = 10;
/** Of a length: what bends less by that is as good. */
constexpr double SAME_BENDING = 1e-9;
/** More triangles than one can run into. */
constexpr std::size_t ALL_OF_THEM = std::numeric_limits<std::size_t>::max();

bool
isBetterFlipped(const CoarsePatch& coarse, std::size_t side)
{
  if (!coarse.canFlip(side))
    return false;
  const std::vector<std::size_t> pair = {side / 3, coarse.edges.across(side) / 3};
  // With the two themselves: otherwise fewer pairs here could be more in all, and flips
  // would go round and round.
  const auto meetings =
      [&](const ccaa::Corners& one, const ccaa::Corners& other, std::size_t enough) {
        const std::size_t of_one = coarse.meetings(one, pair, enough);
        return of_one + coarse.meetings(other, pair, enough - of_one) +
               (ccaa::areasMeet(one, other) ? 1 : 0);
      };
  const std::size_t now =
      meetings(coarse.cornersAt(pair[0]), coarse.cornersAt(pair[1]), ALL_OF_THEM);
  if (now == 0)
    return false;
  const auto [a, b, c, d] = coarse.edges.pairAt(side);
  const std::size_t then = meetings({coarse.at(d), coarse.at(c), coarse.at(b)},
                                    {coarse.at(c), coarse.at(d), coarse.at(a)},
                                    now + 1);
  return then < now ||
         (then == now && coarse.bending.ofFlipped(side) <
                             coarse.bending.of(pair) * (1.0 - SAME_BENDING));
}

/** \param[in,out] crossing triangles that may run into something
 * \return whether anything was flipped */
bool
flipOnce(CoarsePatch& coarse, std::vector<std::size_t>& crossing)
{
  bool has_flipped = false;
  for (std::size_t i = 0; i < crossing.size() && !ccaa::isCancelled(coarse.control);
       ++i)
    for (std::size_t side = 3 * crossing[i]; side < 3 * crossing[i] + 3; ++side)
      if (coarse.edges.isInner(side) && isBetterFlipped(coarse, side)) {
        crossing.push_back(coarse.flip(side));
        has_flipped = true;
      }
  std::sort(crossing.begin(), crossing.end());
  crossing.erase(std::unique(crossing.begin(), crossing.end()), crossing.end());
  return has_flipped;
}

} // namespace

void
flipCrossings(const IncompleteModel& model,
              std::vector<std::size_t> crossing,
              const std::function<bool(const ccaa::Corners&)>& obstructed,
              Patch& patch,
              ccaa::RunControl* control)
{
  if (crossing.empty())
    return;
  CoarsePatch coarse(model, obstructed, patch, control);
  for (int round = 0; round < MOST_ROUNDS && flipOnce(coarse, crossing);)
    ++round;
}

} // namespace pcl::repair
