// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: points the camera at an object.
#pragma once

#include "render/render_settings.h"
#include "survey/model_survey.h"

#include <vector>

class vtkCamera;

namespace app {

/** \brief Aim \a camera so that \a positions fill the picture at zoom 1, without
 * perspective: parallel lines stay parallel, so angles can be judged by eye. */
void
aimCamera(const std::vector<Eigen::Vector3d>& positions,
          const RenderSettings& settings,
          vtkCamera& camera);

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
