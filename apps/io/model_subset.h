// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: parts of a cloud or mesh, with all fields.
#pragma once

#include <pcl/PolygonMesh.h>

#include <vector>

namespace app {

/** \brief The points of \a mesh with a flag, in order and with all fields, and of the
 * polygons given those whose corners all have one. */
pcl::PolygonMesh
takePoints(const pcl::PolygonMesh& mesh,
           const std::vector<char>& wanted,
           const std::vector<pcl::Vertices>& polygons);

/** \brief Sort the polygons into those that touch no flagged point and the others. */
void
splitPolygons(const std::vector<pcl::Vertices>& polygons,
              const std::vector<char>& flagged,
              std::vector<pcl::Vertices>& untouched,
              std::vector<pcl::Vertices>& touched);

} // namespace app
