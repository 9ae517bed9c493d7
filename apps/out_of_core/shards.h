// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the mesh of a run tile by tile as files for others.
#pragma once

#include "io/output_file.h"
#include "out_of_core/tile_steps.h"
#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <string>

namespace app {

/** \brief Ending of the shard of a tile, and the name of the index of all. */
constexpr const char* SHARD_STEP = "ply";
constexpr const char* INDEX_FILE = "index.json";

/** \brief Write the triangles of a tile as a mesh of its own: its points with all
 * fields, then those of other tiles that its triangles use; the property vertex_id is
 * the number of each in the whole. */
void
writeShard(const TilePlan& plan, std::size_t tile);

/** \brief Whether the shard of a tile is there. Fails for one that is not whole, or of
 * another run. */
bool
hasShard(const TilePlan& plan, std::size_t tile);

/** \brief Write the list of all shards with what was found about the whole. */
void
writeIndex(const TilePlan& plan);

/** \brief That list, from the shards, or else without their names from what they would
 * be made of. */
nlohmann::json
describeTiles(const TilePlan& plan);

/** \brief Number of triangles of a tile, and of all. */
std::size_t
countTriangles(const TilePlan& plan, std::size_t tile);
std::uint64_t
countTriangles(const TilePlan& plan);

/** \brief Write the whole mesh as one PLY file: all points in the order of the input,
 * file by file, then the triangles of all tiles, from their shards or from what these
 * would be made of. Memory: that of one tile's points and triangles. Fails for more
 * than 2^32 points. \param[in] triangles how many these are \param[in] keeps if not,
 * what was read is removed */
void
mergeTiles(const TilePlan& plan, std::uint64_t triangles, bool keeps, OutputFile& file);

} // namespace app
