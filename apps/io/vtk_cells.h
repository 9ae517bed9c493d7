// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the surface among the cells of an unstructured VTK grid.
#pragma once

#include "polygon_builder.h"

#include <cstdint>
#include <vector>

namespace app {

/** \brief Add the polygons and strips among the cells of an unstructured grid; a note
 * tells how many others were left out.
 * \param[in] cells one after the other, each as its number of corners and the corners
 * \param[in] types one a cell
 * \return false when the numbers do not fit together */
bool
addSurfaceCells(const std::vector<std::int64_t>& cells,
                const std::vector<std::int64_t>& types,
                PolygonBuilder& builder,
                Warnings& warnings);

} // namespace app
