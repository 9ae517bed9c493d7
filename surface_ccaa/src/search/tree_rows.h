// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the neighbors of many points from any search method.
#pragma once

#include <pcl/surface_ccaa/impl/cloud_runs.h>

#include "mesh/block_loop.h"

#include <cstddef>
#include <vector>

namespace pcl::ccaa {

/** \brief From index in the cloud to rank. */
class RankTable {
public:
  /** \param[in] order rank -> index in the cloud
   * \param[in] cloud_size number of points of the cloud */
  RankTable(const std::vector<index_t>& order, std::size_t cloud_size);

  /** \brief Turn the result of a search around a point into its neighbor row: in ranks,
   * without the point itself, ascending by squared distance and then by rank, whatever
   * the order in which the search method returns them, filled up with
   * NeighborTable::NONE. \param[in]
   * rank the point \param[in] near cloud indices found \param[in] sqr_distances their
   * squared distances \param[in] k length of the row \param[out] row k places */
  void
  fillRow(index_t rank,
          const Indices& near,
          const std::vector<float>& sqr_distances,
          unsigned int k,
          index_t* row) const;

private:
  std::vector<index_t> ranks_;
};

/** \brief The nearest of some points among themselves, asked for point by point; fewer
 * than three points get none.
 * \param[in] search gets these points to search among
 * \param[in] order rank -> index in the cloud
 * \param[in] cloud_size number of points of the cloud
 * \param[in] k length of a row
 * \param[out] rows one of k ranks for each rank, see RankTable::fillRow()
 * \return false when cancelled */
bool
searchRows(const TreeSearch& search,
           const IndicesPtr& order,
           std::size_t cloud_size,
           unsigned int k,
           const LoopContext& context,
           std::vector<index_t>& rows);

} // namespace pcl::ccaa
