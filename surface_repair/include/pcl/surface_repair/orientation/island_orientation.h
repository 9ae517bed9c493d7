// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which side of an island is outside (4.48).

#pragma once

#include <pcl/surface_ccaa/mesh/block_loop.h>
#include <pcl/surface_repair/field/indicator_field.h>
#include <pcl/surface_repair/icadm/incomplete_model.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace repair {

/** \brief What told the outer side of an island. */
enum class SideRule : std::uint8_t {
  NORMALS,    /**< the given normals, where they agree with each other */
  VIEWPOINT,  /**< the sensor positions, which see outer sides only */
  FREE_SIGHT, /**< the way to the enclosing sphere is free (4.48) */
  FIELD,      /**< the field integral with islands that are decided (E4.48-1) */
  UNDECIDED,  /**< none of these: the winding stays as it was */
  ONE_SIDED   /**< there are no two sides */
};

const char*
describe(SideRule rule);

struct IslandSide {
  SideRule rule = SideRule::UNDECIDED;
  bool flipped = false;    /**< wound the other way round now */
  double confidence = 0.0; /**< 0 to 1 */
};

struct OrientationParameters {
  double decided_from = 0.2;    /**< least confidence that decides */
  double sight_clearance = 2.0; /**< k of r = k d: a way closer than this times the mean
                                     free-point spacing to a free point is not free */
};

/** \brief Find the outer side of every island. Changes nothing: see turnIslands(). */
std::vector<IslandSide>
orientIslands(const IncompleteModel& model,
              const BoundaryLoops& loops,
              const OrientationParameters& parameters,
              const ccaa::LoopContext& context);

/** \brief Wind the islands that are flipped the other way round; their normals follow.
 * Boundary loops have to be extracted anew. */
void
turnIslands(IncompleteModel& model, const std::vector<IslandSide>& sides);

} // namespace repair
} // namespace pcl
