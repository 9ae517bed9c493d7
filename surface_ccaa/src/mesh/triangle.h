// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the index triangle all rooms speak of.
#pragma once

#include <pcl/types.h>

#include <Eigen/Core>

#include <array>
#include <vector>

namespace pcl::ccaa {

/** \brief Three vertex indices; the order gives the side (counter-clockwise from
 * outside), but only once a mesh has been oriented (see mesh/orientation.h). */
using Triangle = std::array<pcl::index_t, 3>;
using Triangles = std::vector<Triangle>;

/** \brief Which corner (0 to 2) of a triangle a vertex is; it must be one of them. */
inline int
cornerOf(const Triangle& triangle, pcl::index_t vertex)
{
  return triangle[1] == vertex ? 1 : triangle[2] == vertex ? 2 : 0;
}

/** \brief Vertex positions in double precision, in the units of the cloud. */
using Position = Eigen::Vector3d;
using Positions = std::vector<Position>;

} // namespace pcl::ccaa
