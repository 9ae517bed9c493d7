// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: one repair, from the mesh as it comes to the triangles that
// are new.

#pragma once

#include <pcl/surface_repair/repair_parameters.h>
#include <pcl/surface_repair/repair_report.h>

#include "repair/region_closing.h"

#include <cstddef>
#include <vector>

namespace pcl {
namespace repair {

/** \brief What the repair makes of a model. */
struct RepairedModel {
  /** \brief The input's vertices and triangles first, wound as they should be, then the
   * new ones. A new vertex that is a free point of the mesh has its point; other new
   * ones have none (UNAVAILABLE). Vertices with a point that a lower one has are
   * further fans of it. */
  IncompleteModel model;
  std::size_t input_vertices = 0;
  std::size_t input_triangles = 0;
};

/** \brief Run the method (thesis, Chapter 4): read, orient, classify; join islands;
 * close holes; and again on what came out, as long as that closes anything more.
 * \param[out] report all but `seconds` of writing
 * \return empty when there is no model (report.reading.problem) or after cancelling */
RepairedModel
runRepair(const pcl::PolygonMesh::ConstPtr& mesh,
          const pcl::PCLPointCloud2* free_points,
          const RepairParameters& parameters,
          const ccaa::LoopContext& context,
          RepairReport& report);

} // namespace repair
} // namespace pcl
