// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: complex holes divided until each is simple (4.5).

#pragma once

#include "field/free_point_field.h"
#include "field/shielding.h"
#include "hole/hole_polygon.h"
#include "mesh/block_loop.h"
#include "survey/model_survey.h"

#include <cstddef>
#include <vector>

namespace pcl::repair {

/** \brief A bridge across a hole, in vertices. */
struct DividingBridge {
  std::vector<pcl::index_t> vertices; /**< at least two, ends included */
  Positions points;                   /**< one a vertex */
  Directions normals;                 /**< one a vertex */
  double quality = 0.0;               /**< mean tension (4.41) */
};

/** \brief A hole divided into holes that are simple, or that no force line divides. */
struct DividedHole {
  std::vector<HolePolygon> holes;      /**< at least one */
  std::vector<DividingBridge> bridges; /**< in the order in which they were built */
  Positions new_vertices; /**< the first of them has the number `first_new` */
};

/** \brief What lines are led by and what they must not run through; null: nothing. */
struct SubdivisionGuides {
  const FreePointField* free_points = nullptr;
  const Shield* surface = nullptr;
};

/** \brief Bisect a hole with force lines of its own contour, under effective charges,
 * until every part has at most `simple_edges` edges (4.5).
 *
 * Each division makes the larger part strictly smaller than what was divided, so it
 * ends; a part that no line divides stays as it is. Bridges end at vertices of the
 * contour, no two at the same one, and have points at about the distances that the
 * contour's points have.
 * \param[in] first_new number of the first new vertex
 * \param[in] parameters of the field, the tracker, T and the perturbation; its
 * simple_edges are those up to which a hole is simple */
DividedHole
divideHole(const HolePolygon& hole,
           pcl::index_t first_new,
           const SurveyParameters& parameters,
           const SubdivisionGuides& guides,
           const ccaa::LoopContext& context);

} // namespace pcl::repair
