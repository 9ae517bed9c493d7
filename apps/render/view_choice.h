// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: from where the gaps of a model are seen best.
#pragma once

#include "survey/model_survey.h"

#include <vector>

namespace app {

/** \brief Directions from the model to the camera: one for an open surface that faces
 * one way, such as a range map; else two opposite ones. They are those, of the axes and
 * the diagonals between them, from which most of the boundary, weighted by length,
 * shows its outer side. */
std::vector<Eigen::Vector3d>
chooseViews(const pcl::repair::ModelSurvey& survey);

/** \brief The one direction, of the same, from which most of the boundary is seen; of a
 * model without one most of the surface. */
Eigen::Vector3d
chooseView(const pcl::repair::ModelSurvey& survey);

/** \brief Up in a picture seen from \a view: y or z, in which of them the model is
 * taller, unless the view goes along it. */
Eigen::Vector3d
chooseUp(const pcl::repair::ModelSurvey& survey, const Eigen::Vector3d& view);

} // namespace app
