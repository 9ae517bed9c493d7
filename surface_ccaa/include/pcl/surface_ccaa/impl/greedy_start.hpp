// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: greedy triangulation extended to 3D (thesis 3.3).
#pragma once

#include <pcl/console/print.h>
#include <pcl/search/kdtree.h>
#include <pcl/surface_ccaa/greedy_start.h>
#include <pcl/surface_ccaa/impl/cloud_view.h>

#include <memory>

namespace pcl {

template <typename PointT>
GreedyStart<PointT>::GreedyStart() = default;

template <typename PointT>
GreedyStart<PointT>::~GreedyStart() = default;

template <typename PointT>
void
GreedyStart<PointT>::performReconstruction(pcl::PolygonMesh& output)
{
  performReconstruction(output.polygons);
}

template <typename PointT>
void
GreedyStart<PointT>::performReconstruction(std::vector<pcl::Vertices>& polygons)
{
  if (!tree_)
    tree_ = std::make_shared<search::KdTree<PointT>>(false);
  const ccaa::CloudInput input{
      ccaa::pointArrayOf(*input_), indices_, threads_, progress_, handoff_};
  const std::string error =
      ccaa::runGreedyStart(input,
                           ccaa::treeSearchOf<PointT>(tree_, input_, threads_),
                           parameters_,
                           report_,
                           polygons);
  if (!error.empty())
    PCL_ERROR(
        "[pcl::%s::performReconstruction] %s\n", getClassName().c_str(), error.c_str());
}

} // namespace pcl

#define PCL_INSTANTIATE_GreedyStart(T) template class PCL_EXPORTS pcl::GreedyStart<T>;
