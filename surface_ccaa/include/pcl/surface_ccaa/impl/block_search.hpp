// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: PointBlocks as a search method for any PCL class.
#pragma once

#include <pcl/console/print.h>
#include <pcl/search/impl/search.hpp>
#include <pcl/surface_ccaa/block_search.h>
#include <pcl/surface_ccaa/impl/point_array.h>

#include <algorithm>
#include <limits>

namespace pcl::search {

namespace detail {

inline int
splitNeighbors(const std::vector<ccaa::Neighbor>& neighbors,
               Indices& indices,
               std::vector<float>& sqr_distances)
{
  indices.resize(neighbors.size());
  sqr_distances.resize(neighbors.size());
  for (std::size_t i = 0; i < neighbors.size(); ++i) {
    indices[i] = neighbors[i].point_index;
    sqr_distances[i] = neighbors[i].sqr_distance;
  }
  return static_cast<int>(neighbors.size());
}

/** Square of a radius as a float; a negative one stays negative. */
inline float
sqrRadius(double radius)
{
  if (radius < 0)
    return -1.f;
  const double square = radius * radius;
  return square > double(std::numeric_limits<float>::max())
             ? std::numeric_limits<float>::infinity()
             : static_cast<float>(square);
}

} // namespace detail

template <typename PointT>
BlockSearch<PointT>::BlockSearch() : Search<PointT>("BlockSearch", true)
{}

template <typename PointT>
BlockSearch<PointT>::~BlockSearch() = default;

template <typename PointT>
ccaa::SetInputResult<PointT>
BlockSearch<PointT>::setInputCloud(const PointCloudConstPtr& cloud,
                                   const IndicesConstPtr& indices)
{
  input_ = cloud;
  indices_ = indices;
  const auto points = input_ ? ccaa::pointArrayOf(*input_) : ccaa::PointArray();
  const auto threads = static_cast<int>(threads_);
  const bool in_range =
      !indices_ ||
      (input_ && ccaa::findIndexOutside(*indices_, points.size) == indices_->end());
  if (!indices_)
    blocks_.build(points, threads);
  else if (in_range)
    blocks_.build(points, *indices_, threads);
  else {
    PCL_ERROR("[pcl::%s::setInputCloud] index out of range of the cloud (%zu points)\n",
              this->getName().c_str(),
              points.size);
    blocks_.build({}, threads);
  }
  return static_cast<ccaa::SetInputResult<PointT>>(in_range);
}

template <typename PointT>
int
BlockSearch<PointT>::nearestKSearch(const PointT& point,
                                    int k,
                                    Indices& k_indices,
                                    std::vector<float>& k_sqr_distances) const
{
  const auto count = static_cast<std::size_t>(std::max(k, 0));
  return detail::splitNeighbors(
      blocks_.nearest({point.x, point.y, point.z}, count), k_indices, k_sqr_distances);
}

template <typename PointT>
int
BlockSearch<PointT>::radiusSearch(const PointT& point,
                                  double radius,
                                  Indices& k_indices,
                                  std::vector<float>& k_sqr_distances,
                                  unsigned int max_nn) const
{
  const std::array<float, 3> place = {point.x, point.y, point.z};
  const float sqr_radius = detail::sqrRadius(radius);
  return detail::splitNeighbors(max_nn == 0
                                    ? blocks_.within(place, sqr_radius)
                                    : blocks_.nearest(place, max_nn, sqr_radius),
                                k_indices,
                                k_sqr_distances);
}

} // namespace pcl::search

#define PCL_INSTANTIATE_BlockSearch(T)                                                 \
  template class PCL_EXPORTS pcl::search::BlockSearch<T>;
