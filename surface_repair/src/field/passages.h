// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the way from a point to each of its sources, in full mode.
#pragma once

#include "field/free_point_field.h"
#include "field/indicator_field.h"
#include "field/shielding.h"
#include "field/source_blocks.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::repair {

/** \brief What lies between points and sources; none of it need be there. */
struct Surroundings {
  const FreePointField* free_points = nullptr;
  const Shield* shield = nullptr;
  double tolerance = 0.0; /**< of the shield, units of the cloud */

  bool
  empty() const
  {
    return free_points == nullptr && shield == nullptr;
  }
};

/** \brief The passage from a point to one source. */
struct Passage {
  double ratio = 1.0; /**< effective by true length (E4.424-2) */
  double delta = 1.0; /**< 0 where the surface is in the way (E4.43-6), else 1 */
};

/** \brief Effective length of a passage up to which it matters whether the surface is
 * in its way: beyond it the source weighs next to nothing. Remembers the last exponent.
 */
class ShieldReach {
public:
  double
  operator()(const Falloff& falloff);

private:
  double exponent_ = 0.0, rest_ = 0.0;
};

/** \brief The passage of the straight segment from x to a source as it is. */
Passage
passageOf(const Surroundings& around,
          const Position& x,
          const Position& source,
          double shield_reach);

/** \brief The passages from a point to the sources of its blocks.
 *
 * Both numbers change little from a source to the next one on the boundary. So they are
 * found at a few sources of each run of blocks; between two that agree ratios are
 * linear and the surface is in the way of all or of none, and where two disagree the
 * sources between them are looked at, down to single ones. Reused from query to query
 * by one thread.
 */
class Passages {
public:
  /** \brief Find them for the listed blocks. */
  void
  find(const SourceBlocks& blocks,
       const std::vector<std::uint32_t>& list,
       const FieldQuery& query,
       const Surroundings& around);

  /** \brief LANES values for each block of the list. */
  const std::vector<double>&
  ratios() const
  {
    return ratios_;
  }
  const std::vector<double>&
  deltas() const
  {
    return deltas_;
  }

private:
  std::vector<double> ratios_, deltas_;
  ShieldReach shield_reach_;
};

} // namespace pcl::repair
