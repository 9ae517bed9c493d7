// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what junctions, and pieces without one, leave in doubt.

#pragma once

#include <pcl/surface_repair/repair_parameters.h>
#include <pcl/surface_repair/repair_report.h>

#include "verification/repaired_model.h"

#include <algorithm>
#include <array>
#include <set>
#include <vector>

namespace pcl::repair {

/** \brief Lowest points of two loops, ascending. */
using PointPair = std::array<pcl::index_t, 2>;

inline PointPair
inOrder(pcl::index_t one, pcl::index_t other)
{
  return {std::min(one, other), std::max(one, other)};
}

/** \brief Call visit(point, piece) for each vertex with a triangle that has one of some
 * points. \param[in] points sorted keys: a set or a map */
template <typename Points, typename Visit>
void
visitPieces(const IncompleteModel& model, const Points& points, const Visit& visit)
{
  for (std::size_t v = 0; v < model.point_of_vertex.size() && !points.empty(); ++v) {
    const auto vertex = static_cast<pcl::index_t>(v);
    const pcl::index_t* triangle = model.adjacency.begin(vertex);
    if (points.count(model.point_of_vertex[v]) > 0 &&
        triangle != model.adjacency.end(vertex))
      visit(model.point_of_vertex[v],
            model.island_of[static_cast<std::size_t>(*triangle)]);
  }
}

/** \brief The loops of which the user says that they are to be joined, or are not.
 * \param[in] decisions or null */
std::set<PointPair>
decidedLoops(const Decisions* decisions, bool join);

/** \brief Whether users have decided about what no junction tells. \param[in] decisions
 * or null */
bool
areSettled(const Decisions* decisions);

/** \brief Junctions that are joined on evidence that hardly decides, or only because
 * there is no better one, or that join an island to itself and do not surely carry a
 * handle, where the result has some: by their points, ascending. */
std::vector<RepairDoubt>
weakJunctions(const RepairReport& report, const SurveyParameters& parameters);

/** \brief Junctions of two mouths of tubes, none of which is joined to any other loop,
 * that lack little to be joined: by their points, ascending. */
std::vector<RepairDoubt>
unjoinedMouths(const RepairReport& report, const SurveyParameters& parameters);

/** \brief Junctions that are joined by what they are, but not in the model: by their
 * points, ascending. None where anything is decided, if only where a part was cut off:
 * its pieces may hang together outside it. \param[in] model as it is written */
std::vector<RepairDoubt>
partedJunctions(const IncompleteModel& model,
                const RepairReport& report,
                const SurveyParameters& parameters);

/** \brief Thin necks (ccaa::thinNecks()) in what is new or beside it, unless the user
 * has decided what is joined. */
std::vector<RepairDoubt>
newNecks(const RepairedModel& repaired, const SurveyParameters& parameters);

} // namespace pcl::repair
