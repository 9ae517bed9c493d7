// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: reads points from plain text, a line each.
#pragma once

#include "input_file.h"
#include "model.h"

namespace app {

/** \brief Read .xyz, .txt, .pts and .csv: numbers between spaces, tabs, commas or
 * semicolons, at least three on a line; lines that begin with # or // are comments.
 *
 * A heading (the first line, with or without #) that has a name for each column, the
 * first three being x, y and z, names the fields. Without one, a fourth number is an
 * intensity; the last three of 6 or 7 numbers are a colour if all are whole and 0 to
 * 255, else those of 6 are a normal; others are called field_4, field_5, ... A single
 * number on the first line (.pts) is the number of points and passed over. */
Status
readXyz(const InputFile& file, Model& model);

} // namespace app
