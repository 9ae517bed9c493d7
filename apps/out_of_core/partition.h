// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: cuts clouds of any size into tiles.
#pragma once

#include "out_of_core/tile_plan.h"

#include <functional>
#include <string>
#include <vector>

namespace app {

/** \brief Cut clouds into tiles: one where it may hold all points, else tiles of about
 * a quarter of what one may hold (bisect()). Each tile gets a file of its points, in an
 * order that depends on the points alone, and the folder a plan.
 *
 * The files are read once. Memory: some 100 MB and three times the records of one tile.
 * Where the folder holds the plan of the same run already, nothing is done; with
 * another one it fails, and so it does when files change meanwhile.
 *
 * \param[in] most_points in a tile, at least 1000; more only where all of them are in
 * one place
 * \param[in] threads 0: all; the tiles are the same for any
 * \param[in] goes_on called now and then with the share that is done; false stops
 * \return nothing of use when it was stopped */
TilePlan
partition(const std::vector<std::string>& paths,
          const std::string& folder,
          std::uint64_t most_points,
          const std::string& settings,
          unsigned int threads,
          const std::function<bool(double)>& goes_on);

} // namespace app
