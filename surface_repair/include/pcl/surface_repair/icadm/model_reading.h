// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: from any polygon mesh to an incomplete model.

#pragma once

#include <pcl/surface_ccaa/mesh/block_loop.h>
#include <pcl/surface_ccaa/run_settings.h>
#include <pcl/surface_repair/icadm/incomplete_model.h>
#include <pcl/PCLPointCloud2.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace pcl {
namespace repair {

/** \brief What reading found, and what had to change before it was an ICADM. */
struct ReadingReport {
  std::size_t input_polygons = 0;
  std::size_t invalid_polygons = 0;   /**< index out of range, repeated or not finite */
  std::size_t repeated_triangles = 0; /**< left out: there already, either way round */
  std::size_t overfull_edges = 0; /**< of three triangles and more, where the mesh was
                                       cut into sheets */
  std::size_t separated_fans = 0; /**< that got a vertex of their own: fans of one point
                                       beside its first one */
  std::size_t twist_triangles = 0; /**< left out: they made islands one-sided */
  std::size_t reversed_triangles = 0;
  std::size_t non_finite_points = 0;
  std::size_t points_on_vertices = 0; /**< that are no free points for that reason */
  Eigen::Vector3d global_shift = Eigen::Vector3d::Zero(); /**< taken off all positions
                                       of the model: see pcl::GlobalShift */
  std::size_t dropped_islands = 0; /**< smaller than the user wants them; see
                                        dropIslands() */
  std::size_t dropped_triangles = 0;
  std::string problem; /**< why there is no model; empty: there is one */
};

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
readModel(const pcl::PolygonMesh::ConstPtr& mesh,
          const pcl::PCLPointCloud2* free_points,
          const ccaa::LoopContext& context,
          const ccaa::SideHints& sides = {});

} // namespace repair
} // namespace pcl
