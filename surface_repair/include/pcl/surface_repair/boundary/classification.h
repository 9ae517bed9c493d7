// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: telling holes from rims and the outer border (4.1).

#pragma once

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

/** \brief One loop's class and how sure it is. */
struct LoopClass {
  BoundaryClass boundary_class = BoundaryClass::UNDECIDED;
  double confidence = 0.0; /**< 0 to 1 */
  BoundaryIntegral integral;
  double faced = 0.0; /**< share of the loop that another island's boundary faces */
};

struct ClassificationParameters {
  double decided_from = 0.0; /**< least confidence of a class that is not UNDECIDED;
                                   see classification.cpp for the default */
};

/** \brief Classify all loops of a model. */
std::vector<LoopClass>
classifyBoundaries(const IncompleteModel& model,
                   const BoundaryLoops& loops,
                   const ClassificationParameters& parameters = {});

} // namespace repair
} // namespace pcl
