// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: grows a surface anew where handles may be tunnels.
#pragma once

#include <pcl/surface_ccaa/reconstruction_report.h>

#include "advancing_front/surface_completion.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace pcl::ccaa {

/** \brief Completes a mesh without some of its given triangles, unless that takes more
 * work than it may. \return nothing of use if it does, or after cancelling */
using CompletionAgain = std::function<CompletedMesh(PartialMesh mesh,
                                                    const Reopening& reopening,
                                                    std::uint64_t most_work,
                                                    CompletionReport& report)>;

/** \brief How to complete a mesh once more. Refers to what must outlive it. */
struct Recompletion {
  const PartialMesh& mesh; /**< its given triangles left aside */
  const CompletionAgain& complete;
  std::uint64_t work; /**< that it took first */
  const LoopContext& context;
};

/** \brief A completed mesh with its report. */
struct Completed {
  CompletedMesh mesh;
  CompletionReport report;

  long
  genus() const
  {
    return mesh.topology.genus.value_or(0);
  }

  /** \brief What a body is unlikely to have: handles, openings, points beside its
   * surface, more pieces than one. */
  std::size_t
  flaws() const
  {
    const SurfaceTopology& topology = mesh.topology;
    return 2 * static_cast<std::size_t>(genus()) +
           2 * (std::max<std::size_t>(topology.pieces, 1) - 1) +
           topology.boundary_loops + report.free_points;
  }
};

/** \brief Grows a completed mesh anew where it is narrow, and takes what comes out if
 * it has fewer flaws and no more handles.
 *
 * One by one: around each place that a handle passes through local regrowth looks for
 * what has fewer flaws there (LocalRegrowth::Aim::OPEN_HANDLES); none at a cut. If few
 * handles are left, as not in noise, boundaries grow once more, and if some of these
 * pass through narrow places, or the body has come apart, the other way is tried, too,
 * and what has fewer handles is taken: all within four rings of such places together,
 * then within ten and twenty as long as that helps much. Bodies that are thin all over
 * begin with ten, and have no other way.
 *
 * \param[in] again one by one takes at most three times as much work as first, each
 * number of rings 1.5 times
 * \param[in] is_thin flags for thin places (thinPlaces())
 * \param[in] is_narrow flags for these and for small handles \return first, if nothing
 * is better */
Completed
openNarrowPlaces(const Recompletion& again,
                 const Completed& first,
                 const std::vector<std::uint8_t>& is_thin,
                 const std::vector<std::uint8_t>& is_narrow);

} // namespace pcl::ccaa
