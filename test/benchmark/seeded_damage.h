// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: takes triangles away from a closed surface, by a seed.
#pragma once

#include "closed_models.h"

#include <cstdint>
#include <vector>

namespace bench {

/** \brief Shapes of damage. Sizes are radii as shares of the model's diagonal. */
enum class DamageKind : std::uint8_t {
  BALL,   /**< all within a ball around a point of the surface */
  DISC,   /**< all within a distance along the edges */
  RAGGED, /**< a disc whose outer third is torn at random */
  RING,   /**< a disc but for a smaller one in its middle: an island in a hole */
  CUT     /**< all beyond a plane near an extreme point: stumps of limbs */
};
constexpr int DAMAGE_KINDS = 5;

struct DamageOptions {
  std::uint64_t seed = 1;
  int patches = 12;
  double smallest = 0.005;
  double largest = 0.12;
};

/** \brief A flag for each triangle: taken away. The same seed gives the same flags on
 * every machine. */
std::vector<char>
damageModel(const ClosedModel& model, const DamageOptions& options);

} // namespace bench
