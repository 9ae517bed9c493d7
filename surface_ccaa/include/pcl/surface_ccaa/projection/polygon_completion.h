// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: between the clouds and polygons of PCL and the base
// algorithm.
#pragma once

#include <pcl/surface_ccaa/mesh/side_hints.h>
#include <pcl/surface_ccaa/projection/completion_parameters.h>
#include <pcl/surface_ccaa/run_control.h>
#include <pcl/surface_ccaa/search/curve_order.h>
#include <pcl/types.h>
#include <pcl/Vertices.h>

#include <functional>
#include <string>
#include <vector>

namespace pcl {
namespace ccaa {

/** \brief Neighbors by a caller's search method: for points given by their indices in
 * the cloud, fill a table of k places a point with places in that list, nearest first,
 * -1 where there are no more. Returns false when cancelled. */
using PointSearch = std::function<bool(
    const Indices& points, unsigned int k, std::vector<index_t>& table)>;

/** \brief What a completion is made from. All must outlive the call. */
struct CompletionInput {
  PointArray points;
  PointArray normals;    /**< same size, or empty; outward, of any length, may be NaN */
  PointArray viewpoints; /**< same size, or empty: sensor positions */
  SideHints sides;       /**< what is told for the whole cloud */
  const Indices* selection = nullptr;                /**< points that may be used */
  const std::vector<pcl::Vertices>* given = nullptr; /**< polygons, or null */
  PointSearch search; /**< empty: search::PointBlocks, the fastest */
};

/** \brief What came of it. */
struct CompletionOutput {
  std::vector<pcl::Vertices>
      polygons;              /**< the given ones that stay, then the new ones */
  std::vector<index_t> kept; /**< which of the given triangles, ascending */
  std::string error;         /**< why there is no result, without a full stop */
};

/** \brief The name of the first parameter that is out of range, or null. */
const char*
outOfRange(const CompletionParameters& parameters);

/** \brief completeSurface() for polygons that speak of points of a cloud. Polygons with
 * more than three corners become fans. Points that are not finite, and all but one of
 * several points at one place, get no new triangle; those of the given triangles are
 * used whatever the selection says. */
CompletionOutput
completePolygons(const CompletionInput& input,
                 const CompletionParameters& parameters,
                 int threads,
                 RunControl& control,
                 CompletionReport& report);

} // namespace ccaa
} // namespace pcl
