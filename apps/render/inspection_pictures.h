// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: pictures of what a survey found.
#pragma once

#include "inspect/inspection_files.h"
#include "render/render_settings.h"
#include "survey/model_survey.h"

#include <optional>
#include <vector>

namespace app {

/** \brief From where and how large the pictures are taken. */
struct InspectionView {
  int width = 1600;                    /**< pixels, with the legend */
  int height = 900;                    /**< pixels */
  std::optional<Eigen::Vector3d> view; /**< towards the camera, else chosen */
  std::optional<Eigen::Vector3d> up;   /**< what points up, else chosen */
};

/** \brief Draw loops.png, islands.png, lines.png and slice.png from the layers of an
 * inspection, each with a legend. A closed model is shown from two sides. A picture is
 * left out when there is nothing to show. Needs a display (see display.h).
 * \return pictures without bytes where drawing failed */
std::vector<InspectionPicture>
drawInspection(const pcl::repair::ModelSurvey& survey,
               const pcl::repair::FieldSlice& slice,
               const std::vector<InspectionLayer>& layers,
               const InspectionView& view);

} // namespace app
