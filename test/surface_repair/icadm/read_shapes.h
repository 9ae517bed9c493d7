// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: models read from shapes, for the tests of this room.
#pragma once

#include "icadm/model_reading.h"
#include "support/mesh_asserts.h"
#include "support/shapes.h"

namespace pcl::repair::test {

inline pcl::PolygonMesh::Ptr
meshOf(const ccaa::test::Shape& shape)
{
  return pcl::make_shared<pcl::PolygonMesh>(ccaa::test::toPolygonMesh(shape));
}

inline ReadModel
read(const pcl::PolygonMesh::ConstPtr& mesh)
{
  return readModel(mesh, nullptr, ccaa::LoopContext());
}

inline ReadModel
read(const ccaa::test::Shape& shape)
{
  return read(meshOf(shape));
}

/** \brief The triangles in the numbers of the cloud. */
inline Triangles
pointTriangles(const IncompleteModel& model)
{
  Triangles triangles = model.triangles;
  for (Triangle& triangle : triangles)
    for (pcl::index_t& corner : triangle)
      corner = model.point_of_vertex[static_cast<std::size_t>(corner)];
  return triangles;
}

} // namespace pcl::repair::test
