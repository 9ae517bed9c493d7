// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: by what decisions know their mesh again.
#pragma once

#include <pcl/surface_repair/decisions.h>

#include "mesh/mesh_view.h"

namespace pcl::repair {

/** \brief As that of a PolygonMesh, wherever points and polygons lie. */
MeshFingerprint
fingerprintOf(const ccaa::MeshView& mesh);

} // namespace pcl::repair
