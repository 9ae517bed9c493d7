// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: from any polygon mesh to an incomplete model.

#pragma once

#include <pcl/surface_ccaa/run_settings.h>
#include <pcl/surface_repair/model_findings.h>
#include <pcl/PCLPointCloud2.h>

#include "icadm/incomplete_model.h"
#include "mesh/block_loop.h"
#include "mesh/mesh_view.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace pcl::repair {

/** \brief A model, and what reading had to change. */
struct ReadModel {
  IncompleteModel model;
  ReadingReport report;
};

/** \brief Read a mesh. Manifold, consistently wound input is taken as it is, triangle
 * for triangle. Anything else is cut where it is no manifold, and only there: of the
 * triangles on an edge of three and more those that go on best in each other are pairs,
 * and each such sheet, like each of several fans that touch in a point (bow-ties), gets
 * vertices of its own. All triangles stay but those that are there twice and the few
 * bent ones that turn an island over; within an island they are wound alike. A cloud
 * far from the origin is read less its GlobalShift, which the report tells; so are free
 * points and sensor positions.
 * \param[in] free_points a separate cloud of free points, or null
 * \param[in] sides what is told about the outer side, in the frame of the cloud: where
 * the viewpoints of the vertices come from, if not from the cloud
 * \return with report.problem set when the cloud is unreadable, there is no triangle,
 * or the run was cancelled */
ReadModel
readModel(const ccaa::MeshView& mesh,
          const pcl::PCLPointCloud2* free_points,
          const ccaa::LoopContext& context,
          const ccaa::SideHints& sides = {});

} // namespace pcl::repair
