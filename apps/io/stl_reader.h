// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: reads STL.
#pragma once

#include "input_file.h"
#include "model.h"

namespace app {

/** \brief Read ASCII or binary STL. The format repeats the position of each corner;
 * corners at the same position become one vertex, in order of first appearance. */
Status
readStl(const InputFile& file, Model& model);

} // namespace app
