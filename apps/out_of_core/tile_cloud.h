// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the points of a tile and of what lies around it.
#pragma once

#include "mesh/point_view.h"
#include "out_of_core/tile_points.h"

#include <array>
#include <vector>

namespace app {

/** \brief The points of a tile and of its halo as one cloud, in their order in the
 * whole, so that ties are broken alike by all tiles that see them. */
class TileCloud {
public:
  TileCloud(const TilePlan& plan, std::size_t tile);

  /** \brief The points of a tile with these of others, ascending, in the same order. */
  TileCloud(const TilePlan& plan,
            std::size_t tile,
            const std::vector<pcl::ccaa::WideIndex>& foreign);

  /** \brief Just these points, ascending. */
  TileCloud(const TilePlan& plan, const std::vector<pcl::ccaa::WideIndex>& points);

  /** \brief What the points are in the whole, ascending. */
  const std::vector<pcl::ccaa::WideIndex>&
  wide() const
  {
    return wide_;
  }

  /** \brief Halos of the points themselves, 0 for those that are not sparse. */
  const std::vector<double>&
  halos() const
  {
    return halos_;
  }

  /** \brief With all fields; doubles are rounded as all tiles round them. */
  const pcl::PCLPointCloud2&
  cloud() const
  {
    return cloud_;
  }

  /** \brief The same without a copy; cloud() is of no use then. */
  pcl::PCLPointCloud2
  take()
  {
    return std::move(cloud_);
  }

  /** \brief Place of the first point of the tile itself; the others follow it. */
  std::size_t
  firstOwn() const
  {
    return first_own_;
  }

  /** \brief Place of a point of the whole. Throws a Failure where it is not there. */
  pcl::index_t
  placeOf(pcl::ccaa::WideIndex index) const;

private:
  explicit TileCloud(const TilePlan& plan);
  void
  addThese(const TilePlan& plan,
           std::vector<pcl::ccaa::WideIndex>::const_iterator next,
           std::vector<pcl::ccaa::WideIndex>::const_iterator end);
  void
  addOwn(const TilePlan& plan, std::size_t tile);
  void
  add(const TilePlan& plan, std::size_t part, const TilePoints& points, std::size_t i);

  void
  finish();

  pcl::PCLPointCloud2 cloud_;
  std::vector<pcl::ccaa::WideIndex> wide_;
  std::vector<double> halos_;
  std::array<std::size_t, 3> position_offsets_{};
  std::size_t first_own_ = 0;
};

} // namespace app
