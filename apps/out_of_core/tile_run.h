// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: all steps of a run tile by tile in one process.
#pragma once

#include "out_of_core/tile_steps.h"

#include <cstdint>
#include <functional>
#include <string>

namespace app {

/** \brief Bytes that a step takes for each point of its tile and halo, more or less. */
constexpr std::uint64_t TILE_BYTES = 700;

/** \brief Do what is left to do of the steps of all tiles, several tiles at a time as
 * far as the memory goes, each with its share of the threads; then write shards and
 * index. The files are the same for any memory and threads.
 * \param[in] keeps the folder is for others, who may go on with it; else what no later
 * step reads is removed, and no shards or index are made
 * \param[in] memory bytes that may be used; one tile is worked on in any case
 * \param[in] tell called from the calling thread with the step and the share of the
 * whole that is done; false stops, and a Failure says so */
void
runTiles(const TilePlan& plan,
         std::uint64_t memory,
         unsigned int threads,
         bool keeps,
         const std::function<bool(const char*, double)>& tell);

} // namespace app
