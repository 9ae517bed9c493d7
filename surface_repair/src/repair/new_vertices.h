// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what new vertices inherit.

#pragma once

#include "mesh/cloud_access.h"
#include "verification/repaired_model.h"

#include <vector>

namespace pcl::repair {

/** \brief What is to be appended to the cloud. */
struct AddedVertices {
  std::vector<std::size_t> numbers;      /**< of the model's vertices, ascending */
  std::vector<ccaa::NewVertex> vertices; /**< one each */
};

/** \brief The vertices that have no point of the cloud, or none of their own. A new one
 * inherits from input vertices at the boundary of its patch, the nearer the more. */
AddedVertices
addedVertices(const RepairedModel& repaired, ccaa::RunControl* control = nullptr);

} // namespace pcl::repair
