// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the points of a tile on disk.
#pragma once

#include <Eigen/Geometry>

#include "mesh/cloud_access.h"
#include "out_of_core/step_file.h"
#include "out_of_core/tile_plan.h"
#include "tiles/world_grid.h"

#include <cstring>
#include <functional>
#include <string>
#include <vector>

namespace app {

/** \brief Ending of the file of a tile's points. */
constexpr const char* POINTS_STEP = "points";

/** \brief A point with a halo of its own (pcl::ccaa::Tile::SPARSE). */
struct SparsePoint {
  std::uint32_t point = 0; /**< its number in the tile */
  float halo = 0.0F;
};

/** \brief The file is looked at in place: it takes no memory of its own but what is
 * touched while the object lives. */
class TilePoints {
public:
  /** \brief Points whose box the file tells. */
  static constexpr std::size_t BLOCK = 4096;

  TilePoints(const TilePlan& plan, std::size_t tile);

  /** \brief Write the points of a tile in their final order. */
  static void
  write(const TilePlan& plan,
        const std::string& path,
        const std::vector<char>& records,
        const std::vector<PointSource>& sources,
        const std::vector<SparsePoint>& sparse);

  std::size_t
  size() const
  {
    return count_;
  }

  const std::uint8_t*
  record(std::size_t point) const
  {
    return records_ + point * record_bytes_;
  }

  PointSource
  source(std::size_t point) const
  {
    PointSource source;
    std::memcpy(&source, sources_ + point * sizeof(PointSource), sizeof(PointSource));
    return source;
  }

  /** \brief Where it is, rounded as all tiles round it. */
  pcl::ccaa::Position
  position(std::size_t point) const
  {
    return pcl::ccaa::roundedTo(step_, layout_.tripleAt(record(point)));
  }

  /** \brief Calls \a use(point) for those within a box, ascending. */
  void
  forEachIn(const Eigen::AlignedBox3d& box,
            const std::function<void(std::size_t)>& use) const;

  /** \brief Its own halo, 0 unless it is sparse. */
  double
  halo(std::size_t point) const;

  /** \brief Those that another tile knows, ascending. */
  std::vector<std::size_t>
  knownTo(const pcl::ccaa::Tile& tile) const;

private:
  StepReader reader_;
  pcl::ccaa::PointView layout_;
  std::size_t record_bytes_;
  double step_;
  std::size_t count_ = 0;
  const std::uint8_t* records_ = nullptr;
  const char* sources_ = nullptr;
  std::vector<std::array<double, 6>> boxes_;
  std::vector<SparsePoint> sparse_; /**< ascending */
};

/** \brief A view that tells where positions lie in the records of a plan: for
 * tripleAt() alone. */
pcl::ccaa::PointView
recordView(const TilePlan& plan);

/** \brief Calls use(tile, points, number in the tile) for points of any tiles, given
 * ascending by an iterator and its end; each tile's file is opened once. */
template <typename Iterator, typename Use>
void
forPoints(const TilePlan& plan, Iterator next, Iterator end, const Use& use)
{
  while (next != end) {
    const std::size_t tile = plan.tiling.ownerOf(*next);
    const pcl::ccaa::Tile& owner = plan.tiling.tiles[tile];
    const TilePoints points(plan, tile);
    for (; next != end && owner.owns(*next); ++next)
      use(tile, points, static_cast<std::size_t>(*next - owner.first));
  }
}

} // namespace app
