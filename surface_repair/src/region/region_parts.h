// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the holes of a region, divided and filled in several ways.

#pragma once

#include "patch/patch_assembly.h"
#include "region/fill_strategy.h"
#include "region/filling_choice.h"
#include "region/region.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::repair {

/** \brief Operations that closing something of so many edges and samples may take (see
 * ccaa::RunControl): n log n. What exceeds them is left for TOO_COSTLY. */
std::uint64_t
workFor(std::size_t size);

/** \brief The same for a region. */
std::uint64_t
workFor(const Region& region);

/** \brief A region is tried with its samples for one part in so many of that: those of
 * lost ears and arms take less, strays any amount. */
constexpr std::uint64_t SAMPLED = 4;

/** \brief Which of the fills of a part serves a strategy. */
constexpr std::size_t
fillsIn(const FillStrategy& strategy)
{
  return strategy.without_free ? 2 : strategy.avoids ? 1 : 0;
}

/** \brief The holes of a region, or parts of those that are complex. What it is made of
 * must outlive it. */
class RegionParts {
public:
  /** \brief All of them, whether they are filled or not; none before divide(). */
  std::vector<FilledPart> parts;

  RegionParts(const ClosingPlace& place,
              const Region& region,
              const SurfaceObstacle& obstacle,
              const ccaa::LoopContext& context);

  /** \brief All lies in the plane of its rim: what the user wants, or else what the rim
   * is and whether free points speak against it. */
  bool
  isFlat() const
  {
    return flat_;
  }

  /** \brief ICM2 -> ICM1 (4.5). \param[in] strategies of each hole, as in fills()
   * \param[out] holes of the region, which get their bridges */
  void
  divide(const std::vector<std::size_t>& strategies, std::vector<HoleOutcome>& holes);

  /** \brief The fills of all parts in one way or the other: made once, they serve every
   * strategy (4.7). \param[in] strategies place in FILL_STRATEGIES, of each hole; what
   * is GIVEN_UP is not filled */
  const std::vector<ChosenFilling>&
  fills(const FillStrategy& strategy, const std::vector<std::size_t>& strategies);

private:
  bool
  isToBeFlat() const;
  bool
  hasSamples(const HolePolygon& hole) const;

  const ClosingPlace& place_;
  const Region& region_;
  const SurfaceObstacle& obstacle_;
  const ccaa::LoopContext& context_;
  bool flat_;
  std::array<std::vector<ChosenFilling>, 3>
      fills_; /**< plain, avoiding, and basic ones avoiding */
};

} // namespace pcl::repair
