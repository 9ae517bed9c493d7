// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: reads OFF.
#pragma once

#include "input_file.h"
#include "model.h"

namespace app {

/** \brief Read ASCII OFF, with normals (NOFF) and vertex colours (COFF, also CNOFF).
 * Colours of faces are not taken over. */
Status
readOff(const InputFile& file, Model& model);

} // namespace app
