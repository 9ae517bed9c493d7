// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: greedy triangulation extended to 3D (thesis 3.3).
#pragma once

#include <pcl/search/kdtree.h>
#include <pcl/surface_ccaa/greedy/greedy_triangulation.h>
#include <pcl/surface_ccaa/greedy/usable_points.h>
#include <pcl/surface_ccaa/greedy_start.h>
#include <pcl/surface_ccaa/impl/block_search.hpp>
#include <pcl/surface_ccaa/impl/tree_rows.hpp>
#include <pcl/surface_ccaa/mesh/block_loop.h>
#include <pcl/surface_ccaa/mesh/polygon_access.h>
#include <pcl/surface_ccaa/search/block_search.h>
#include <pcl/surface_ccaa/search/cloud_points.h>

#include <chrono>
#include <memory>

namespace pcl {

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
  using Clock = std::chrono::steady_clock;
  polygons.clear();
  report_ = {};
  if (!hasValidInput())
    return;
  const int threads = ccaa::resolveThreads(threads_);
  ccaa::RunControl control(progress_);
  const auto start = Clock::now();
  Neighborhoods found;
  const bool searched = findNeighborhoods(threads, control, found);
  const auto between = Clock::now();
  report_.search_seconds = std::chrono::duration<double>(between - start).count();
  if (searched) {
    const ccaa::Triangles triangles = ccaa::greedyTriangulation(
        found.points, found.rows, parameters_, threads, control, report_);
    ccaa::writePolygons(triangles,
                        found.points.point_indices,
                        ccaa::LoopContext{threads, &control, "polygons"},
                        polygons);
  }
  report_.greedy_seconds =
      std::chrono::duration<double>(Clock::now() - between).count();
  report_.cancelled = control.cancelled();
  if (report_.cancelled)
    polygons.clear();
}

template <typename PointT>
bool
GreedyStart<PointT>::hasValidInput() const
{
  const char* name = "GreedyStart";
  if (const char* wrong = ccaa::outOfRange(parameters_)) {
    PCL_ERROR("[pcl::%s::performReconstruction] %s is out of range\n", name, wrong);
    return false;
  }
  const auto outside = ccaa::findIndexOutside(*indices_, input_->size());
  if (outside != indices_->end()) {
    PCL_ERROR("[pcl::%s::performReconstruction] index %d is outside the cloud of %zu "
              "points\n",
              name,
              static_cast<int>(*outside),
              input_->size());
    return false;
  }
  return true;
}

template <typename PointT>
bool
GreedyStart<PointT>::findNeighborhoods(int threads,
                                       ccaa::RunControl& control,
                                       Neighborhoods& found)
{
  if (!control.report("neighbors", 0))
    return false;
  if (!tree_)
    tree_ = std::make_shared<search::KdTree<PointT>>(false);
  const bool has_blocks =
      std::dynamic_pointer_cast<search::BlockSearch<PointT>>(tree_) != nullptr;
  const bool done = has_blocks ? searchBlocks(threads, control, found)
                               : searchTree(threads, control, found);
  report_.points = found.points.size();
  if (done && report_.points < 3)
    PCL_ERROR("[pcl::%s::performReconstruction] %zu usable points, at least 3 are "
              "needed\n",
              getClassName().c_str(),
              report_.points);
  return done && report_.points >= 3;
}

/** All rows at once from the blocks. */
template <typename PointT>
bool
GreedyStart<PointT>::searchBlocks(int threads,
                                  ccaa::RunControl& control,
                                  Neighborhoods& found)
{
  const auto tree = std::static_pointer_cast<search::BlockSearch<PointT>>(tree_);
  const unsigned int threads_of_tree = tree->getNumberOfThreads();
  tree->setNumberOfThreads(static_cast<unsigned int>(threads));
  tree->setInputCloud(input_, indices_);
  const std::vector<index_t>& order = tree->getPointBlocks().order();
  report_.skipped_points = indices_->size() - order.size();
  const ccaa::PointArray points = ccaa::pointArrayOf(*input_);
  const auto unique = std::make_shared<Indices>(ccaa::removeDuplicates(points, order));
  report_.duplicate_points = order.size() - unique->size();
  if (report_.duplicate_points > 0)
    tree->setInputCloud(input_, unique);
  tree->setNumberOfThreads(threads_of_tree);
  found.points = ccaa::rankPoints(points, tree->getPointBlocks().order(), threads);
  auto table = tree->getPointBlocks().allNearest(
      parameters_.neighbors, ccaa::PointBlocks::Distances::OMIT, threads, &control);
  if (!table)
    return false;
  found.table = std::move(*table);
  found.rows = {found.table.rows() > 0 ? found.table.row(0) : nullptr, found.table.k()};
  return true;
}

/** Point by point, with any search method. */
template <typename PointT>
bool
GreedyStart<PointT>::searchTree(int threads,
                                ccaa::RunControl& control,
                                Neighborhoods& found)
{
  const ccaa::PointArray points = ccaa::pointArrayOf(*input_);
  const std::vector<index_t> order = ccaa::curveOrder(points, *indices_, threads);
  report_.skipped_points = indices_->size() - order.size();
  const auto unique = std::make_shared<Indices>(ccaa::removeDuplicates(points, order));
  report_.duplicate_points = order.size() - unique->size();
  found.points = ccaa::rankPoints(points, *unique, threads);
  const unsigned int k = parameters_.neighbors;
  const ccaa::LoopContext loop{threads, &control, "neighbors"};
  const bool done =
      ccaa::searchRows<PointT>(*tree_, input_, unique, k, loop, found.searched);
  found.rows = {found.searched.data(), k};
  return done;
}

} // namespace pcl

#define PCL_INSTANTIATE_GreedyStart(T) template class PCL_EXPORTS pcl::GreedyStart<T>;
