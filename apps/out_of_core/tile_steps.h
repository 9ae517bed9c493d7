// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the steps of a reconstruction tile by tile.
#pragma once

#include <pcl/surface_ccaa/run_settings.h>

#include "out_of_core/repair_files.h"
#include "out_of_core/tile_files.h"

#include <cstddef>
#include <functional>
#include <set>
#include <vector>

namespace app {

/** \brief How a step runs. The result is the same for any. */
struct StepRun {
  unsigned int threads = 1;                  /**< 0: all */
  pcl::ccaa::ProgressCallback progress = {}; /**< false from it stops the step */
  std::function<void(std::size_t tile)> wait =
      {}; /**< until the step is done for a lower tile; empty: it is */
};

// Each step reads what the steps before it have written for its tile and the tiles
// around it, and writes one file, whole or not at all; where the file is there already,
// nothing is done. A step that was stopped throws a Failure. They come in this order,
// all tiles of a step before the next one.

/** \brief The whole chain on the points of a tile and its halo; triangles that are too
 * near the end of what it knows are left out. */
void
meshTile(const TilePlan& plan, std::size_t tile, const StepRun& run);

/** \brief Which of the triangles at the border of a tile all tiles made that see them
 * (pcl::ccaa::agree()), and where some did not. */
void
joinTile(const TilePlan& plan, std::size_t tile);

/** \brief Group the places where tiles did not agree; each group belongs to the tile of
 * its first point. Of a large one each tile gets the part that is its own. */
void
groupAllDisputes(const TilePlan& plan);

/** \brief Close the groups of a tile (pcl::ccaa::closeSeam()), after the tiles that
 * close other parts of them before. */
void
closeTile(const TilePlan& plan, std::size_t tile, const StepRun& run);

/** \brief Tiles whose files closing and winding a tile read, beside those around it. */
struct SeamLinks {
  std::set<std::size_t> parts;   /**< whose triangles closeTile() reads */
  std::set<std::size_t> closers; /**< whose closing windTile() reads */
  std::set<std::size_t> earlier; /**< whose closing closeTile() reads: all lower */
};
SeamLinks
seamLinks(const TilePlan& plan, std::size_t tile);

/** \brief The final triangles of a tile, wound alike in each piece, and what the pieces
 * say about their outer sides. */
void
windTile(const TilePlan& plan, std::size_t tile, const StepRun& run);

/** \brief The outer side of all pieces of all tiles. */
void
decideAllSides(const TilePlan& plan);

/** \brief The triangles of a tile, outward, before any repair. A triangle on an edge
 * over which windings cannot agree is left out. */
TileSurface
readSurface(const TilePlan& plan, std::size_t tile);

// With --repair also these, before shards are written:

/** \brief The boundary loops of all tiles, and which of them are repaired together. */
void
findHoles(const TilePlan& plan);

/** \brief Tiles whose surface repairing a tile reads, with the points of those around
 * them. */
std::vector<std::size_t>
holeParts(const TilePlan& plan, std::size_t tile);

/** \brief How many points repairing takes, by tile: those in the regions of its loops,
 * what is in several for each. */
std::vector<std::uint64_t>
repairPoints(const TilePlan& plan);

/** \brief Repair the clusters of a tile, each with the surface around it as a mesh of
 * its own (pcl::ForceLineHoleRepair): what stays open at its cuts stays as it is. */
void
repairTile(const TilePlan& plan, std::size_t tile, const StepRun& run);

/** \brief Drop patches that meet one of a cluster with a lower number, number the new
 * vertices of all tiles, and add up what the repairs tell. */
void
numberRepairs(const TilePlan& plan);

/** \brief What repairing a tile has made, without patches that were dropped. */
RepairedTile
readStayingPatches(const TilePlan& plan, std::size_t tile);

/** \brief The triangles of a tile after its repair, where there is one; new vertices
 * are the last of those of others. */
TileSurface
readRepairedSurface(const TilePlan& plan, std::size_t tile);

} // namespace app
