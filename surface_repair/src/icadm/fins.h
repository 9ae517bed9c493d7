// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: small islands that hang on a surface that is whole.

#pragma once

#include "icadm/incomplete_model.h"

namespace pcl {
namespace repair {

/** \brief Mark the islands that are fins: small, and with an edge that two triangles of
 * another island have, too, between the same points. They were cut off where three
 * triangles met; nothing is missing between them and the surface.
 * Cost: linear in the triangles of the model. */
void
markFins(IncompleteModel& model);

} // namespace repair
} // namespace pcl
