// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: meshes out of the bytes a fuzzer makes up.
#pragma once

#include "fuzz_bytes.h"
#include "support/shapes.h"

namespace fuzz {

/** \brief A small named shape, and a list of edits of it, until the bytes end:
 * triangles are taken away, turned round, doubled or joined to other vertices, vertices
 * are moved, made one, lost as not finite, or added as free points. Random triangles
 * alone would hardly ever be a surface. */
pcl::ccaa::test::Shape
damagedMesh(Bytes& bytes);

} // namespace fuzz
