// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: PointBlocks as a search method for any PCL class.
#pragma once

#include <pcl/search/search.h>
#include <pcl/surface_ccaa/impl/compat.h>
#include <pcl/surface_ccaa/impl/point_blocks.h>

namespace pcl::search {

/** \brief Exact neighbor search over blocks of points along a space-filling curve.
 *
 * Set it wherever a class takes a search method: \code
 * normal_estimation.setSearchMethod(std::make_shared<pcl::search::BlockSearch<PointT>>());
 * \endcode
 * Who needs the neighbors of all points gets them several times faster from
 * getPointBlocks() (`pcl/surface_ccaa/impl/point_blocks.h`) than by one call per point.
 *
 * Results always ascend by distance, then by point index. Points with a NaN or infinite
 * coordinate are never found, and nothing is found around them. The query is found too
 * where it is a point of the cloud, as with the other search methods. Const calls may
 * run in parallel. Building costs O(N), a query about O(log N + results).
 *
 * setInputCloud() takes the coordinates in; points moved afterwards are found where
 * they were.
 */
template <typename PointT>
class BlockSearch : public Search<PointT> {
public:
  using Ptr = shared_ptr<BlockSearch<PointT>>;
  using ConstPtr = shared_ptr<const BlockSearch<PointT>>;
  using PointCloudConstPtr = typename Search<PointT>::PointCloudConstPtr;

  using Search<PointT>::indices_;
  using Search<PointT>::input_;
  using Search<PointT>::nearestKSearch;
  using Search<PointT>::radiusSearch;

  BlockSearch();
  ~BlockSearch() override;

  /** \brief Threads for setInputCloud(), 0 (the default) = all. */
  void
  setNumberOfThreads(unsigned int threads)
  {
    threads_ = threads;
  }

  unsigned int
  getNumberOfThreads() const
  {
    return threads_;
  }

  /** \brief Take in the cloud that is searched. An index out of range is an error and
   * leaves nothing to be found.
   * \param[in] cloud the cloud; null counts as empty
   * \param[in] indices the points to search among; null means all
   * \return since PCL 1.14: whether the indices were in range */
  ccaa::SetInputResult<PointT>
  setInputCloud(const PointCloudConstPtr& cloud,
                const IndicesConstPtr& indices = IndicesConstPtr()) override;

  /** \brief The nearest points to a place.
   * \param[in] point the place
   * \param[in] k how many at most; less than 1 finds nothing
   * \param[out] k_indices cloud indices, resized to the number found
   * \param[out] k_sqr_distances squared distances, resized alike
   * \return number found */
  int
  nearestKSearch(const PointT& point,
                 int k,
                 Indices& k_indices,
                 std::vector<float>& k_sqr_distances) const override;

  /** \brief The points up to a distance from a place; those exactly so far are in.
   * \param[in] point the place
   * \param[in] radius the distance, in units of the cloud; a negative one finds nothing
   * \param[out] k_indices cloud indices, resized to the number found
   * \param[out] k_sqr_distances squared distances, resized alike
   * \param[in] max_nn if not 0, only the nearest so many
   * \return number found */
  int
  radiusSearch(const PointT& point,
               double radius,
               Indices& k_indices,
               std::vector<float>& k_sqr_distances,
               unsigned int max_nn = 0) const override;

  /** \brief The structure itself, for queries about all points at once. It speaks of
   * cloud indices where it says "the caller's index". */
  const ccaa::PointBlocks&
  getPointBlocks() const
  {
    return blocks_;
  }

private:
  ccaa::PointBlocks blocks_;
  unsigned int threads_ = 0;
};

} // namespace pcl::search

#ifdef PCL_NO_PRECOMPILE
#include <pcl/surface_ccaa/impl/block_search.hpp>
#endif
