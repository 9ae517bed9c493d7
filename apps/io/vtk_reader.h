// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: reads legacy VTK polygon data.
#pragma once

#include "input_file.h"
#include "model.h"

namespace app {

/** \brief Read a legacy .vtk file with DATASET POLYDATA, ASCII or binary, as VTK 3 to 9
 * writes it: points, polygons, triangle strips and all point data; of an
 * UNSTRUCTURED_GRID the flat cells. Lines, single vertices and cell data are not taken
 * over. */
Status
readVtk(const InputFile& file, Model& model);

} // namespace app
