// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: telling holes from rims and the outer border (4.1).

#pragma once

#include <pcl/surface_ccaa/mesh/block_loop.h>
#include <pcl/surface_repair/boundary/boundary_integral.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace repair {

/** \brief What a boundary loop bounds. */
enum class BoundaryClass : std::uint8_t {
  HOLE,         /**< missing area inside a region */
  ISLAND_RIM,   /**< the outer boundary of a region that others face */
  OUTER_BORDER, /**< the outer boundary of an open surface: nothing is beyond it */
  UNDECIDED     /**< neither is clear, such as the mouth of a tube */
};

/** \brief Name for reports, such as "hole". */
const char*
describe(BoundaryClass boundary_class);

/** \brief What speaks for a hole and what for a rim. */
struct LoopEvidence {
  BoundaryIntegral integral; /**< D (D4.1-1) */
  /** \brief Turns to the right while the loop is walked, measured on the surface: 1 for
   * a flat hole, -1 for a flat rim, 0 for the mouth of a tube. By Gauss and Bonnet it
   * does not depend on how jagged the loop is. */
  double turning = 0.0;
  /** \brief Area of the loop's island, other loops closed, over that of the least
   * surface that would close this loop: 1 for a flat island, 2 for half a sphere, large
   * for a small hole. Only bounds of the least surface are known: what is taken is the
   * value nearest to 2 that is possible. */
  double area_ratio = 2.0;
  /** \brief The island is a tube, and this is one of its two mouths. */
  bool is_tube_mouth = false;
  /** \brief Another loop of the island is a clearer rim and far larger: this is none.
   */
  bool within_rim = false;

  /** \brief All of it as one number: above 0 a hole, below 0 a rim, from -4 (flat
   * rim) up; a hole in a large surface has 10 and more. */
  double
  score() const;
};

/** \brief One loop's class and how sure it is. */
struct LoopClass {
  BoundaryClass boundary_class = BoundaryClass::UNDECIDED;
  double confidence = 0.0; /**< 0 to 1: tanh(|score| / 2) */
  LoopEvidence evidence;
  double faced = 0.0; /**< share of a rim's points that another island faces, 0 to 1;
                           0 for other loops */
};

/** \brief When a class of a boundary counts as decided. */
struct ClassificationParameters {
  /** \brief Least confidence of a class that is not UNDECIDED, 0 to 1. */
  double decided_from = 0.4;
  /** \brief Share of a rim that must be faced by other islands before it is an
   * ISLAND_RIM and no OUTER_BORDER, 0 to 1. */
  double faced_from = 0.25;
};

/** \brief Classify all loops of a model.
 *
 * D decides together with two witnesses that know what D cannot: how the loop turns on
 * the surface, and how large its island is. On a sphere with one round opening all
 * three agree; the stump of a limb, where D is about 0 or below, is known for a hole by
 * its island's size. Loops of one-sided islands are UNDECIDED.
 *
 * Cost: about 3 us a boundary edge (see farthestPoints()), 0.1 us a triangle.
 * The result is the same for any number of threads.
 * \param[in] loops of this model, all of them: others of the same island matter
 * \param[in] context a thread takes whole loops \return empty after cancelling */
std::vector<LoopClass>
classifyBoundaries(const IncompleteModel& model,
                   const BoundaryLoops& loops,
                   const ClassificationParameters& parameters = {},
                   const ccaa::LoopContext& context = {});

} // namespace repair
} // namespace pcl
