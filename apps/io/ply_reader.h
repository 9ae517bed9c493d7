// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: reads PLY, ASCII and binary of both byte orders.
#pragma once

#include "input_file.h"
#include "model.h"

namespace app {

/** \brief What of a file is wanted. */
enum class Contents { POINTS, POINTS_AND_POLYGONS };

/** \brief Read a PLY file: all vertex properties become fields (red, green, blue become
 * rgb, nx becomes normal_x); faces of any number of corners and triangle strips become
 * polygons. Polygon indices are not yet checked. */
Status
readPly(const InputFile& file, Contents contents, Model& model);

} // namespace app
