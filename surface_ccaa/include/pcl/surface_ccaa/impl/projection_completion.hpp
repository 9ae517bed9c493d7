// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the base algorithm of CCAA (thesis 3.1, 3.5).
#pragma once

#include <pcl/console/print.h>
#include <pcl/surface_ccaa/impl/cloud_view.h>
#include <pcl/surface_ccaa/projection_completion.h>

#include <utility>

namespace pcl {

template <typename PointT>
ProjectionCompletion<PointT>::ProjectionCompletion() = default;

template <typename PointT>
ProjectionCompletion<PointT>::~ProjectionCompletion() = default;

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
  ccaa::CompletionInput input;
  input.points = ccaa::pointArrayOf(*input_);
  input.selection = indices_;
  input.threads = threads_;
  input.progress = progress_;
  input.handoff = handoff_;
  input.normals = ccaa::normalArrayOf(*input_);
  input.viewpoints = ccaa::viewpointArrayOf(*input_);
  input.sides = ccaa::sidesOf(*input_, side_hints_);
  input.partial_mesh = partial_mesh_.get();
  input.cut_points = cut_points_;
  ccaa::TreeSearch search;
  if (tree_)
    search = ccaa::treeSearchOf<PointT>(tree_, input_, threads_);
  if (tree_ && search.blocks == nullptr)
    input.search = &search;
  ccaa::CompletionOutput output = ccaa::runCompletion(input, parameters_, report_);
  if (!output.error.empty())
    PCL_ERROR("[pcl::%s::performReconstruction] %s\n",
              getClassName().c_str(),
              output.error.c_str());
  polygons = std::move(output.polygons);
  kept_ = std::move(output.kept);
  side_tally_ = report_.sides;
}

} // namespace pcl

#define PCL_INSTANTIATE_ProjectionCompletion(T)                                        \
  template class PCL_EXPORTS pcl::ProjectionCompletion<T>;
