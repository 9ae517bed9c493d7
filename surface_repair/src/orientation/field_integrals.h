// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how the islands' boundaries attract each other (E4.48-1).

#pragma once

#include "boundary/boundary_loop.h"
#include "mesh/block_loop.h"

#include <cstddef>
#include <vector>

namespace pcl::repair {

/** \brief The field integral E4.48-1 over the boundaries of one island, with another
 * island's boundaries as the sources, both wound as they are. */
struct PairIntegral {
  std::size_t base = 0;
  std::size_t source = 0;
  double attraction = 0.0; /**< integral of f . m db, f = H n */
  double magnitude = 0.0;  /**< integral of |f . m| db */
};

/** \brief All pairs of islands that reach each other, by base, then source.
 *
 * H is the sum over its sources, s changes sign with tau_O, and n with the winding of
 * the base: so turning either island changes only the sign of its pair integrals, and
 * every variant of windings can be read off this one table. To keep it so, n is the
 * island's own normal. L_2 is \a room times the gap at each place. */
std::vector<PairIntegral>
pairIntegrals(const BoundaryLoops& loops,
              double room,
              const ccaa::LoopContext& context);

} // namespace pcl::repair
