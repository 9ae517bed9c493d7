// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: holes to be closed together, and what becomes of them.

#pragma once

#include <pcl/surface_repair/repair_parameters.h>
#include <pcl/surface_repair/repair_report.h>

#include "hole/hole_polygon.h"
#include "patch/surface_obstacle.h"
#include "subdivision/hole_subdivision.h"

#include <cstddef>
#include <vector>

namespace pcl::repair {

/** \brief How the cloud holds positions: new vertices get places that it can hold. */
struct CloudFrame {
  bool float_positions = true;
  Position origin = Position::Zero(); /**< of the model, in the frame of these floats */
};

/** \brief What regions are closed in. All of it must outlive the closing. */
struct ClosingPlace {
  const IncompleteModel& model;
  const SurveyGuides& guides;
  const RepairParameters& parameters; /**< those of the survey tell what is simple */
  CloudFrame frame;
  bool mends = true; /**< patches that run into something are filled anew there */
};

/** \brief A part of a model, where nothing guides and nothing is mended in turn. */
inline ClosingPlace
withinPart(const IncompleteModel& model,
           const RepairParameters& parameters,
           const CloudFrame& frame)
{
  static const SurveyGuides none{};
  return {model, none, parameters, frame, false};
}

/** \brief Holes to be closed together: bridges run between them. */
struct Region {
  std::vector<HolePolygon> holes;
  std::vector<bool> is_certain; /**< of each: to be closed whatever a sensor says, since
                                   the user or bridges do; none where it is empty */
  CreaseVertices creases;       /**< that its holes have */
  std::vector<std::size_t> samples; /**< free points of the missing area */
  Cap cap = Cap::SMOOTH;            /**< AUTO for a single loop only */
  std::size_t bridge_vertices = 0;  /**< new vertices on bridges of all regions: numbers
                                         of others begin after these */
};

/** \brief The same where free points tell nothing of it. */
inline Region
withoutSamples(Region region)
{
  region.samples.clear();
  return region;
}

/** \brief What became of one hole of a region. */
struct HoleOutcome {
  OpenReason open = OpenReason::NONE;
  std::string filling;                 /**< name of the method that closed it */
  std::size_t tries = 0;               /**< that failed before */
  std::vector<DividingBridge> bridges; /**< that divided it */
};

struct ClosedRegion {
  Patch patch; /**< its holes are numbered as in the region */
  std::vector<HoleOutcome> holes;
  bool without_samples = false; /**< they are strays: tried without */
};

} // namespace pcl::repair
