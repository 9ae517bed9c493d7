// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the stages of the method that write no triangles. Each
// fills in what a survey knows from then on, and how long that took.

#pragma once

#include "survey/model_survey.h"

namespace pcl::repair {

/** \brief Cloud and polygons as islands, free points and what is known of sensors
 * (D1.3-1), without the islands that are to be left out. reading.problem says why there
 * is no model. */
ModelSurvey
readSurvey(const ccaa::MeshView& mesh,
           const pcl::PCLPointCloud2* free_points,
           const SurveyParameters& parameters,
           const ccaa::LoopContext& context);

/** \brief Turn islands outward (4.48), and extract their boundaries (D4.1-2). They come
 * before classes: which way a loop runs depends on them. Nothing after a failed
 * reading. */
void
orientIslands(const SurveyParameters& parameters,
              const ccaa::LoopContext& context,
              ModelSurvey& survey);

/** \brief What the user has decided about the loops of the input. What does not fit
 * becomes reading.problem. Nothing after a failed reading. */
void
takeDecisions(const SurveyParameters& parameters, ModelSurvey& survey);

/** \brief Holes, rims and borders (D4.1-1), and the class of the model (D4.1-4). */
void
classifyBoundaries(const SurveyParameters& parameters,
                   const ccaa::LoopContext& context,
                   ModelSurvey& survey);

/** \brief ICM3 -> ICM2: lines between islands (4.41, 4.44), bridges (4.32) of the
 * junctions that evidence supports, and the contours that they make (4.47); also lines
 * across complex holes, where they are wanted. */
void
bridgeIslands(const SurveyParameters& parameters,
              const ccaa::LoopContext& context,
              ModelSurvey& survey);

/** \brief A survey of what a model has become: in order again, of its classes and
 * bridges nothing is known yet. \param[in] before of which the model's positions,
 * points, viewpoints, triangles and adjacency are up to date
 * \param[in] used which free points are vertices now */
ModelSurvey
putInOrder(ModelSurvey before,
           const std::vector<bool>& used,
           const ccaa::LoopContext& context);

} // namespace pcl::repair
