// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: between the indices of a cloud and the ranks of a run.
#pragma once

#include <pcl/surface_ccaa/greedy/greedy_parameters.h>
#include <pcl/surface_ccaa/greedy/ranked_points.h>
#include <pcl/surface_ccaa/search/curve_order.h>

#include <cstddef>
#include <vector>

namespace pcl {
namespace ccaa {

/** \brief The name of the first parameter that is out of range, or null. */
const char*
outOfRange(const GreedyParameters& parameters);

/** \brief Points in a given order, one per place.
 * \param[in] points the cloud
 * \param[in] order indices into it */
RankedPoints
rankPoints(const PointArray& points, const std::vector<index_t>& order, int threads);

/** \brief From index in the cloud to rank. */
class RankTable {
public:
  /** \param[in] order rank -> index in the cloud
   * \param[in] cloud_size number of points of the cloud */
  RankTable(const std::vector<index_t>& order, std::size_t cloud_size);

  /** \brief Turn the result of a search around a point into its neighbor row: in ranks,
   * without the point itself, ascending by squared distance and then by rank, whatever
   * the order in which the search method returns them, filled up with NONE. \param[in]
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

} // namespace ccaa
} // namespace pcl
