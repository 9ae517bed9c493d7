// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the base algorithm of CCAA (thesis 3.1, 3.5).
#pragma once

#include <pcl/search/kdtree.h>
#include <pcl/surface_ccaa/impl/block_search.hpp>
#include <pcl/surface_ccaa/impl/tree_rows.hpp>
#include <pcl/surface_ccaa/mesh/block_loop.h>
#include <pcl/surface_ccaa/projection/polygon_completion.h>
#include <pcl/surface_ccaa/projection_completion.h>
#include <pcl/surface_ccaa/search/block_search.h>
#include <pcl/surface_ccaa/search/cloud_points.h>
#include <pcl/surface_ccaa/search/cloud_sides.h>

#include <memory>
#include <utility>

namespace pcl {

template <typename PointT>
void
ProjectionCompletion<PointT>::performReconstruction(pcl::PolygonMesh& output)
{
  performReconstruction(output.polygons);
}

template <typename PointT>
void
ProjectionCompletion<PointT>::performReconstruction(
    std::vector<pcl::Vertices>& polygons)
{
  polygons.clear();
  kept_.clear();
  report_ = {};
  ccaa::CompletionOutput output;
  output.error = faultOfInput();
  if (output.error.empty()) {
    ccaa::RunControl control(progress_);
    ccaa::CompletionInput input;
    input.points = ccaa::pointArrayOf(*input_);
    input.normals = ccaa::normalArrayOf(*input_);
    input.viewpoints = ccaa::viewpointArrayOf(*input_);
    input.sides = ccaa::sidesOf(*input_, side_hints_);
    input.selection = indices_.get();
    input.given = partial_mesh_ ? &partial_mesh_->polygons : nullptr;
    if (tree_ && !std::dynamic_pointer_cast<search::BlockSearch<PointT>>(tree_))
      input.search = [&](const auto& points, auto k, auto& table) {
        return searchTree(points, k, control, table);
      };
    output = ccaa::completePolygons(
        input, parameters_, ccaa::resolveThreads(threads_), control, report_);
  }
  if (!output.error.empty())
    PCL_ERROR("[pcl::%s::performReconstruction] %s\n",
              getClassName().c_str(),
              output.error.c_str());
  polygons = std::move(output.polygons);
  kept_ = std::move(output.kept);
  side_tally_ = report_.sides;
}

template <typename PointT>
std::string
ProjectionCompletion<PointT>::faultOfInput() const
{
  if (const char* wrong = ccaa::outOfRange(parameters_))
    return std::string(wrong) + " is out of range";
  const auto outside = ccaa::findIndexOutside(*indices_, input_->size());
  if (outside != indices_->end())
    return "index " + std::to_string(*outside) + " is outside the cloud of " +
           std::to_string(input_->size()) + " points";
  if (partial_mesh_) {
    const std::size_t points = static_cast<std::size_t>(partial_mesh_->cloud.width) *
                               partial_mesh_->cloud.height;
    if (points != 0 && points != input_->size())
      return "the partial mesh has " + std::to_string(points) + " points, the cloud " +
             std::to_string(input_->size());
  }
  return {};
}

/** Point by point, with any search method. */
template <typename PointT>
bool
ProjectionCompletion<PointT>::searchTree(const Indices& points,
                                         unsigned int k,
                                         ccaa::RunControl& control,
                                         std::vector<index_t>& table)
{
  const ccaa::LoopContext loop{
      ccaa::resolveThreads(threads_), &control, "partial mesh"};
  return ccaa::searchRows<PointT>(
      *tree_, input_, std::make_shared<const Indices>(points), k, loop, table);
}

} // namespace pcl

#define PCL_INSTANTIATE_ProjectionCompletion(T)                                        \
  template class PCL_EXPORTS pcl::ProjectionCompletion<T>;
