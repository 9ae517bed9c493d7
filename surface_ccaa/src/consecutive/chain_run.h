// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the working data of one run of a chain.
#pragma once

#include <pcl/surface_ccaa/umbrella_filter.h>
#include <pcl/PolygonMesh.h>
#include <pcl/types.h>

#include "consecutive/provenance.h"
#include "consecutive/stage_settings.h"
#include "mesh/block_loop.h"
#include "mesh/curve_order.h"
#include "run/stage_clock.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace pcl::ccaa {

/** \brief What a stage usually takes of the time, for the progress of the whole. */
constexpr double START_WEIGHT = 3;
constexpr double FILTER_WEIGHT = 1;
constexpr double BASE_WEIGHT = 3;
constexpr double NORMALS_WEIGHT = 0.5;

/** \brief "start", "start 2", ... */
std::string
startName(std::size_t number);

/** \brief What a chain has after one of its filter runs. */
struct ChainMesh {
  std::shared_ptr<PolygonMesh> mesh; /**< the whole cloud; polygons only while an
                                          algorithm looks at them (writePolygons()) */
  Triangles triangles;               /**< of cloud indices */
  std::shared_ptr<VertexAdjacency> adjacency; /**< of them; null: unknown */
  TriangleLabels labels;                      /**< of the triangles */
  std::vector<PointRole> roles;               /**< of the cloud's points */
};

/** \brief The selected points that can have triangles. */
struct ChainPoints {
  IndicesPtr usable;       /**< cloud indices of the finite ones */
  std::size_t skipped = 0; /**< how many are not finite */
  bool is_selection =
      false; /**< more were left out than those, or the order is another */
};

/** \brief The working data of one run. */
struct ChainRun {
  ChainRun(const ProgressCallback& progress, int number_of_threads)
  : control(progress), threads(number_of_threads)
  {}

  /** \brief The next part of the chain, which is expected to take `weight` of
   * `total_weight`. */
  StageProgress
  beginStage(const std::string& name, double weight)
  {
    stage = name;
    const double begin = weight_done / total_weight;
    weight_done += weight;
    return {control, name, begin, weight_done / total_weight};
  }

  /** \brief For loops of the chain itself: cancelled with it, but not told about. */
  LoopContext
  loop() const
  {
    return {threads, nullptr, "", BLOCK_SIZE};
  }

  RunControl control;
  int threads;
  std::string stage; /**< present one, for messages */
  double weight_done = 0;
  double total_weight = 1;
  std::size_t point_count = 0; /**< of the cloud */
  ChainPoints points;
  SideHints sides;   /**< what is known about the outer side, for all parts */
  ChainMesh current; /**< after the last stage that was kept */
};

/** \brief The finite ones among the selected points.
 * \param[in] indices the selection, all below the number of points; taken over without
 * a copy when all of them are finite */
ChainPoints
selectUsablePoints(const PointArray& points,
                   const IndicesPtr& indices,
                   const LoopContext& context);

/** \brief Those whose umbrella is not closed. */
IndicesPtr
selectOpenPoints(const ChainRun& run);

std::size_t
countInternalPoints(const std::vector<PointRole>& roles);

/** \brief Boundary and internal points. */
std::size_t
countConnectedPoints(const std::vector<PointRole>& roles);

/** \brief Leave out the triangles that a completion has replaced.
 * \param[in] kept see MeshCompletion::keptTriangles() */
void
keepOnly(const std::vector<index_t>* kept, ChainMesh& chain);

/** \brief Take over what the base algorithm has made of the triangles of a chain.
 * Points that have got triangles are no longer free, whatever else they are.
 *
 * \param[in] triangles begin with those of the chain that were kept
 * \param[in] kept see MeshCompletion::keptTriangles()
 * \param[in] label of the new ones */
void
takeOver(Triangles triangles,
         const std::vector<index_t>* kept,
         std::uint8_t label,
         ChainMesh& chain);

} // namespace pcl::ccaa
