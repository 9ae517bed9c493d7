// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: reads PCD, ASCII, binary and compressed.
#pragma once

#include "input_file.h"
#include "model.h"

namespace app {

/** \brief Read PCL's own format. All fields keep their names and types, except that
 * positions of double precision become float32; width and height of an organised cloud
 * stay. The viewpoint counts as known when it is not the origin, which PCL writes when
 * it knows no better. */
Status
readPcd(const InputFile& file, Model& model);

} // namespace app
