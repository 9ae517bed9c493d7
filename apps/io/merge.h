// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: several views of one object as one cloud.
#pragma once

#include "model.h"

#include <string>
#include <vector>

namespace app {

/** \brief A cloud and the name it is told by. */
struct NamedModel {
  std::string name;
  Model model;
};

/** \brief All points one cloud after the other, with the fields that all clouds have in
 * the same type; a note tells which were left out. Colours agree with or without an
 * alpha. Where the sensors stood at different places, each point gets that of its file
 * as vp_x, vp_y, vp_z; where not all are known, none does, and a note says so.
 * Coordinates stay as they are; a note tells of units that differ. Fails when there are
 * more points than PCL can index. */
void
mergeModels(std::vector<NamedModel>& parts, Model& whole);

/** \brief Give a portion of one part the fields of the whole. \param[in] layout a cloud
 * that mergeModels() made of parts without points \param[in] viewpoint of the part */
void
conformTo(const pcl::PCLPointCloud2& layout,
          const Viewpoint& viewpoint,
          pcl::PCLPointCloud2& cloud);

} // namespace app
