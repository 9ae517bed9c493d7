// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the repair of one region, to look at before all is
// repaired.
#pragma once

#include <pcl/surface_repair/decisions.h>

#include "cli/repair_run.h"
#include "inspect/inspection.h"
#include "survey/model_survey.h"

#include <string>

namespace app {

/** \brief What became of a loop or junction. */
struct LocalRepair {
  std::string told;          /**< a sentence */
  std::size_t triangles = 0; /**< new ones; 0: it stays open */
  InspectionLayer patches;   /**< these, by what made them; in the survey's frame */
};

/** \brief The loops that the repair of a region is about: both of a junction; a loop
 * and those that it is to be joined to. \param[in] chosen a loop of the decisions, or
 * their number and a junction */
std::vector<std::size_t>
regionOf(const pcl::repair::Decisions& decisions, std::size_t chosen);

/** \brief Do with a loop or junction what the decisions say, and with nothing else. The
 * surface within a diagonal of the region's box is repaired as a mesh of its own, in
 * which all other boundaries stay open.
 *
 * What the whole repair makes there may differ where it is about more than that: what
 * farther parts of the surface or other patches are in the way of, other loops that the
 * field comes from, and a class or junction that other decisions change.
 *
 * Cost: a look at each vertex and triangle of the model, and the repair of the part.
 * \param[in] task by which the survey was made; its free points are in the survey
 * \param[in] decisions about the survey's loops, in their order */
LocalRepair
repairLocally(const RepairTask& task,
              const pcl::repair::ModelSurvey& survey,
              const pcl::repair::Decisions& decisions,
              std::size_t chosen);

} // namespace app
