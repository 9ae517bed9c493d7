// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what the repair makes of a model.

#pragma once

#include "icadm/incomplete_model.h"

#include <cstddef>

namespace pcl::repair {

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

} // namespace pcl::repair
