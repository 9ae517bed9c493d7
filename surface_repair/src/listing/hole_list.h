// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which boundaries are to be closed, and which together.

#pragma once

#include <pcl/surface_repair/repair_parameters.h>
#include <pcl/surface_repair/repair_report.h>

#include "icadm/pinched_points.h"
#include "region/region.h"
#include "survey/model_survey.h"

#include <cstddef>
#include <vector>

namespace pcl::repair {

/** \brief A boundary that is left, be it a loop or a contour over bridges. */
struct OpenHole {
  HolePolygon polygon;
  std::vector<std::size_t> bridges;   /**< of the survey, that it passes */
  OpenReason open = OpenReason::NONE; /**< why it is not to be closed; else NONE */
  std::size_t loop = NONE;            /**< of the survey; NONE: a contour */
  std::size_t other_loop = NONE;      /**< it is the ring between the two */
  Cap cap = Cap::AUTO;                /**< what the user decided */
  bool is_wanted = false;             /**< the user wants it closed */
};

/** \brief All boundaries of a survey after bridging, and the regions to be closed. */
struct HoleList {
  std::vector<OpenHole> holes;
  /** Of holes to be closed: those that bridges connect, or that meet twice. */
  std::vector<std::vector<std::size_t>> regions;
  /** Of the model, for a point in which holes meet: polygons have the vertex that is
   * kept, see weldPinches(). */
  VertexMap replaced;
  CreaseVertices creases;          /**< on all bridges that are creases */
  std::size_t bridge_vertices = 0; /**< inner points of all bridges */
  std::size_t islands = 0;         /**< once all regions are closed */
};

/** \brief List loops and contours. A contour over bridges is to be closed unless it
 * bounds the joined surface from outside, which its own D, turning and the area of the
 * islands that it joins tell (4.1); a loop by its class. What the user wants comes
 * first. Loops that samples link are one hole.
 * \param[in] longest_join gap over which samples may do that */
HoleList
listHoles(const ModelSurvey& survey,
          const FillingParameters& parameters,
          double longest_join = 0.0);

} // namespace pcl::repair
