// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which points of a cloud belong to which tile.
#pragma once

#include "out_of_core/tile_buckets.h"

#include <cstdint>
#include <vector>

namespace app {

/** \brief Shares the points of buckets out to tiles of about the same size. */
class PointSharing {
public:
  /** \brief Most points of a bucket, where a tile may hold so many. */
  static std::uint64_t
  mostInBucket(std::uint64_t most_points);

  /** \brief What a tile may hold is one tile. */
  PointSharing(TileBuckets& buckets, std::uint64_t most_points);

  std::size_t
  tiles() const
  {
    return tiles_.size();
  }

  /** \brief The entries of a tile; none in rare cases. Each tile is taken once. */
  std::vector<char>
  take(std::size_t tile, const pcl::ccaa::PointView& view);

private:
  TileBuckets& buckets_;
  std::vector<TileBuckets::Part> parts_;
  std::vector<pcl::ccaa::Box> tiles_;
  std::vector<std::size_t> uses_; /**< of a part: tiles that are still to be taken */
};

} // namespace app
