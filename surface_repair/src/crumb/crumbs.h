// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: islands that are too small to be joined by bridges.

#pragma once

#include "pass/passes.h"

#include <cstddef>
#include <set>
#include <vector>

namespace pcl::repair {

/** \brief Crumbs: discs of few triangles. They carry little orientation and few
 * bridges, and what bridges join at them easily becomes a handle. They wait until the
 * others are closed; then each is laid into the patch that covers it, which cannot
 * change the topology. */
struct Crumbs {
  Triangles triangles;             /**< corners are places in `positions` */
  std::vector<std::size_t> places; /**< of the triangles in the input, ascending */
  Positions positions;
  std::vector<pcl::index_t> point_of_vertex;
  Positions viewpoints; /**< of the vertices; else empty */

  bool
  empty() const
  {
    return triangles.empty();
  }
};

/** \brief Take out the discs of fewer than so many triangles, and of less than a small
 * share of those of the largest island. \return what was taken out of the survey, which
 * is in order again if there was anything */
Crumbs
setCrumbsAside(std::size_t fewer_than,
               const ccaa::LoopContext& context,
               ModelSurvey& survey);

/** \brief The same once bridges have failed: discs of few triangles, larger than
 * crumbs, that could not be joined. \param[in] unjoined vertices at boundaries that
 * could not */
Crumbs
setUnjoinedAside(std::size_t fewer_than,
                 const std::set<pcl::index_t>& unjoined,
                 const Course& course);

/** \brief Make crumbs islands of the model again; input vertices and triangles come in
 * the input's order then. */
void
putCrumbsBack(const Crumbs& crumbs, const Course& course);

/** \brief Lay small discs that are islands of a model into the patches that cover them:
 * an opening is cut around the shadow of each, and the ring between them is closed.
 *
 * A disc stays an island where no patch lies near it, or every ring would run through
 * something; where patches run through it they are opened. New triangles may be other
 * ones afterwards; input ones stay.
 * \param[in] fewer_than triangles of a disc */
void
layCrumbs(std::size_t fewer_than, const Course& course);

} // namespace pcl::repair
