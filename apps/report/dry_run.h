// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what a repair would do, told without doing it.
#pragma once

#include "cli/repair_options.h"
#include "survey/model_survey.h"
#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <string>

namespace app {

/** \brief What a repair would find to do. */
struct RepairPlan {
  std::size_t holes = 0;             /**< loops to be closed */
  std::size_t rims = 0;              /**< loops of islands to be joined */
  std::size_t undecided = 0;         /**< loops that may stay open */
  std::size_t turned_islands = 0;    /**< inside out */
  std::size_t removed_triangles = 0; /**< repeated and twisted ones */
  std::size_t cut_edges = 0;         /**< of three triangles and more */

  bool
  isEmpty() const
  {
    return holes + rims + undecided + turned_islands + removed_triangles + cut_edges ==
           0;
  }
};

RepairPlan
planRepair(const pcl::repair::ModelSurvey& survey,
           const pcl::repair::RepairParameters& method);

/** \brief Add the plan, and the parameters that are taken from the data, to the report
 * of a survey. */
void
describePlan(const RepairSettings& settings,
             const pcl::repair::ModelSurvey& survey,
             nlohmann::json& report);

/** \brief One line. */
std::string
summarizePlan(const RepairPlan& plan);

/** \brief The largest holes and the parameters taken from the data, a line each. */
std::string
tellPlan(const RepairSettings& settings, const pcl::repair::ModelSurvey& survey);

} // namespace app
