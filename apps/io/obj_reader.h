// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: reads Wavefront OBJ.
#pragma once

#include "input_file.h"
#include "model.h"

namespace app {

/** \brief Read vertices (with colours, if each has one), normals (if each vertex gets
 * one) and faces. Texture coordinates, materials, groups and lines are not taken over.
 */
Status
readObj(const InputFile& file, Model& model);

} // namespace app
