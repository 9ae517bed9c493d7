// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: closed surfaces to be damaged, from files or made to order.
#pragma once

#include <pcl/PolygonMesh.h>

#include "icadm/incomplete_model.h"
#include "mesh/triangle_adjacency.h"

#include <string>
#include <vector>

namespace bench {

/** \brief A closed surface of one piece. */
struct ClosedModel {
  std::string name;
  pcl::repair::Positions positions;
  pcl::repair::Triangles triangles;
  pcl::ccaa::TriangleAdjacency adjacency;
  double diagonal = 0; /**< of the bounding box */
  double area = 0;
};

/** \brief The path of a file of the shared data (see cloudList()). */
std::string
sharedFile(const std::string& name);

/** \brief Files of the shared data that are closed surfaces of one piece. */
const std::vector<std::string>&
closedFiles();

/** \brief Read a file of the shared data. Throws std::runtime_error when it cannot be
 * read or is not closed. */
ClosedModel
readClosedModel(const std::string& name);

/** \brief A unit sphere, a torus and a cube of some ten thousand triangles each. */
std::vector<ClosedModel>
madeModels();

/** \brief The model without the triangles that are flagged, with positions as doubles.
 */
pcl::PolygonMesh::Ptr
damagedMesh(const ClosedModel& model, const std::vector<char>& removed);

double
areaOf(const pcl::repair::Triangle& triangle, const pcl::repair::Positions& positions);

} // namespace bench
