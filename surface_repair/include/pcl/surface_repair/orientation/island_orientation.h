// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which side of an island is outside (4.48).

#pragma once

#include <pcl/surface_ccaa/mesh/block_loop.h>
#include <pcl/surface_ccaa/mesh/orientation.h>
#include <pcl/surface_repair/field/indicator_field.h>
#include <pcl/surface_repair/icadm/incomplete_model.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace repair {

/** \brief What told the outer side of an island. */
enum class SideRule : std::uint8_t {
  NORMALS,        /**< the given normals, where they agree with each other */
  VIEWPOINT,      /**< the sensor positions, which see outer sides only */
  VOLUME,         /**< the only island, closed but for small openings: its volume is
                     positive */
  FREE_SIGHT,     /**< the way to the enclosing sphere is free (4.48) */
  FIELD,          /**< the field integral with islands that are decided (E4.48-1) */
  UNDECIDED,      /**< none of these: the winding stays as it was */
  ONE_SIDED,      /**< there are no two sides */
  TOLD_VIEWPOINT, /**< the viewpoint that the user tells, before all others */
  UP,             /**< the direction that the user tells, after that */
  PLANE,          /**< a guess of the reconstruction: up from the dominant plane */
  ORIGIN          /**< as VIEWPOINT, the origin being taken for the sensor's place */
};

const char*
describe(SideRule rule);

/** \brief What was decided about the side of an island. */
struct IslandSide {
  SideRule rule = SideRule::UNDECIDED;
  bool flipped = false;    /**< wound the other way round now */
  double confidence = 0.0; /**< 0 to 1 */
};

/** \brief When a rule decides about the side of an island. */
struct OrientationParameters {
  /** \brief What is told about the outer side; goes before the other rules. */
  ccaa::SideHints sides;
  /** \brief Balance of the votes, 0 to 1, from which given normals agree with each
   * other. Default 0.5: three of four. Viewpoints and up are clear from
   * ccaa::VOTE_MARGIN on. */
  double agreement = 0.5;
  /** \brief Balance from which free sight makes a standard island. Default 0.3. */
  double clear_sight = 0.3;
  /** \brief Share of the ways of the better side that must be free for that, 0 to 1:
   * what is seen through a gap errs easily. Default 0.5. */
  double least_sight = 0.5;
  /** \brief Balance of the field integral, 0 to 1, from which it decides alone.
   * Default 0.3. */
  double clear_field = 0.5;
  /** \brief Balance from which field and sight together decide, 0 to 2. Default 0.2.
   */
  double decided_from = 0.2;
  /** \brief k of r = k d (4.48): a way closer than this times the mean free-point
   * spacing to a free point is not free. Default 1. */
  double sight_clearance = 1.0;
  /** \brief L_2 in gaps to the next island. Default 2.5. */
  double room = 2.5;
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
