// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: one pass over all holes that are to be closed.

#pragma once

#include "listing/hole_list.h"
#include "pass/region_memory.h"
#include "pass/repair_log.h"

#include <cstddef>
#include <unordered_map>
#include <vector>

namespace pcl::repair {

/** \brief Why a hole stayed open. */
struct Failure {
  OpenReason open = OpenReason::NONE;
  std::size_t tries = 0;
};

/** \brief Of holes, at their vertices. */
using Failures = std::unordered_map<pcl::index_t, Failure>;

/** \brief Whether a hole at a vertex was left for INTERSECTION. */
bool
isObstructed(const Failures& failed, pcl::index_t vertex);

/** \brief A vertex of each of two boundaries. */
using VertexPair = std::pair<pcl::index_t, pcl::index_t>;

/** \brief What a pass adds to a model, and what it does not close. */
struct ClosedHoles {
  Triangles triangles;
  Positions positions;                       /**< of new vertices */
  std::vector<pcl::index_t> point_of_vertex; /**< of these; UNAVAILABLE: none */
  std::vector<bool> used;                    /**< of each free point: it is a vertex */
  Failures failed;
  std::vector<VertexPair> failed_pairs; /**< see failedPairs() */
  bool has_changed_others = false; /**< boundaries that stay are not all as they were:
                                        not only whole ones were closed */
};

/** \brief Close the regions of a list (see closeRegions()).
 * \param[in,out] list its welded vertices are forgotten when nothing could be closed
 * \param[in,out] survey points in which holes meet are one vertex afterwards, see
 * weldPinches(), unless nothing could be closed \param[in] stage for progress
 * \param[in,out] memory of what could not be closed before */
ClosedHoles
closeHoles(const RepairParameters& parameters,
           const CloudFrame& frame,
           const ccaa::LoopContext& context,
           const char* stage,
           HoleList& list,
           ModelSurvey& survey,
           RegionMemory& memory,
           RepairLog& log);

/** \brief Make what was closed part of the model, once. Holes that meet in a point and
 * stayed open get vertices of their own there again.
 * \param[in,out] list forgets its welded vertices
 * \param[in,out] closed holds nothing to be added any more; vertices of failures are
 * renumbered with those of the model \param[in,out] input_vertices leading vertices
 * that came with the input */
void
addToModel(const ccaa::LoopContext& context,
           HoleList& list,
           ClosedHoles& closed,
           IncompleteModel& model,
           std::size_t& input_vertices);

} // namespace pcl::repair
