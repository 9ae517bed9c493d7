// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: clouds of any size, written point by point.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace bench {

/** \brief Write points of a closed bumpy surface, of radius 1 and no handle, in random
 * order, as binary PLY. \param[in] shift added to all x, to move it against the grid
 * \param[in] noise deviation of each coordinate, in mean distances of points */
void
writeBumpy(const std::string& path,
           std::uint64_t points,
           std::uint64_t seed,
           double shift = 0.0,
           double noise = 0.0);

/** \brief Write what scanners between five times five houses of 20 by 20 units see of
 * them and the ground, each scan as binary PCD with its viewpoint: rays spread evenly
 * over all directions below 60 degrees, of which those count that meet something within
 * 60 units. \return the names of the files, FOLDER/scan_N.pcd */
std::vector<std::string>
writeCity(const std::string& folder,
          std::uint64_t points,
          std::uint64_t seed,
          std::size_t scans);

} // namespace bench
