// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which force lines may become bridges between islands.

#pragma once

#include "survey/model_survey.h"

#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace pcl::repair {

/** \brief The lines that bridges may follow, in the order they were traced: those that
 * are believed in junctions that are joined, all of a junction that the user wants
 * joined; but for those that are too long or connect what the user wants apart.
 * \param[out] refused see SurveyedBridges::refused */
std::vector<ForceLine>
wantedLines(const ModelSurvey& survey,
            const SurveyParameters& parameters,
            std::vector<std::size_t>& refused);

/** \brief Pairs of loops that the user wants joined, the lower one first, ascending. */
std::set<std::pair<std::size_t, std::size_t>>
wantedPairs(const ModelSurvey& survey);

/** \brief Whether the user wants the loops of a junction joined. */
bool
isWanted(const Junction& junction, const ModelSurvey& survey);

/** \brief Straight lines between pairs of boundaries that the user wants joined and
 * that no line connects, such as the mouths of a tunnel: from each edge of the boundary
 * of fewer edges to the nearest place of the other one, resampled. \param[in]
 * boundaries of SurveyedBridges::loops, one a curve */
std::vector<ForceLine>
wantedChords(const ModelSurvey& survey,
             const BoundaryEdges& boundaries,
             double spacing);

} // namespace pcl::repair
