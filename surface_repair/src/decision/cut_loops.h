// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the part of a mesh, and where it was cut from the rest.
#pragma once

#include <pcl/surface_repair/decisions.h>
#include <pcl/PolygonMesh.h>

#include <functional>
#include <memory>

namespace pcl::repair {

/** \brief That all boundary loops of a mesh stay as they are which run anywhere along a
 * cut: there the surface goes on in what is not given. Cost: that of reading the mesh.
 * \param[in] is_boundary whether the edge between two points is one of the whole, not
 * of a cut \return null where no loop runs along a cut */
std::shared_ptr<const Decisions>
leaveCutsOpen(const pcl::PolygonMesh::ConstPtr& mesh,
              const std::function<bool(pcl::index_t, pcl::index_t)>& is_boundary);

} // namespace pcl::repair
