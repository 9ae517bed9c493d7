// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the clouds that benchmarks run on when none is named.
#pragma once

#include <string>
#include <vector>

namespace bench {

/** \brief A named list of words for makeCloud(), of those files that are there.
 *
 * The files lie in the folder named by the environment variable PSR_SHARED_DATA, else
 * in `../shared/data` beside the source tree. Lists:
 * - bunny: the Stanford Bunny;
 * - closed: closed surfaces, cleanly sampled;
 * - igea: one of them with noise, half the points, outliers or varying density;
 * - scenes: raw scans of rooms, buildings and terrain.
 *
 * Throws std::invalid_argument for another name. */
std::vector<std::string>
cloudList(const std::string& name);

} // namespace bench
