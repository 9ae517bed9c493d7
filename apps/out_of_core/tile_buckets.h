// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: records of points on disk, by the cell they lie in.
#pragma once

#include "mesh/point_view.h"
#include "out_of_core/tile_plan.h"
#include "tiles/bisection.h"
#include "tiles/world_grid.h"

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

namespace app {

/** \brief An octree that grows as points come, with a file for each leaf of a cloud
 * that takes more than 64 MB. Its leaves depend on the points alone, not on their
 * order. Throws a Failure where a file cannot be written. */
class TileBuckets {
public:
  /** \param[in] folder for the files, which is there
   * \param[in] records a view that tells where positions lie in a record */
  TileBuckets(std::string folder,
              std::size_t record_bytes,
              const pcl::ccaa::PointView& records,
              std::uint64_t most_points);

  void
  add(const std::uint8_t* record, PointSource source);

  /** \brief One of the leaves. */
  struct Part {
    pcl::ccaa::GridCell cell;
    pcl::ccaa::Box box;                           /**< around its points */
    std::array<pcl::ccaa::CountedBox, 8> octants; /**< around those of each octant */
  };

  /** \brief The leaves, ascending. */
  std::vector<Part>
  parts() const;

  /** \brief The records of a leaf, each followed by its source; drop() forgets them. */
  std::vector<char>
  read(const pcl::ccaa::GridCell& cell) const;

  void
  drop(const pcl::ccaa::GridCell& cell);

  /** \brief Those without a position that the grid has a cell for. */
  std::vector<PointSource>
  takeNowhere(std::vector<char>& records);

  std::size_t
  entryBytes() const
  {
    return record_bytes_ + sizeof(PointSource);
  }

private:
  struct Leaf {
    std::uint64_t count = 0;
    std::array<pcl::ccaa::CountedBox, 8> octants;
    std::vector<char> waiting;
    std::string path;
  };
  struct CellHash {
    std::size_t
    operator()(const pcl::ccaa::GridCell& cell) const;
  };
  using Leaves = std::unordered_map<pcl::ccaa::GridCell, Leaf, CellHash>;

  Leaves::iterator
  leafAt(const pcl::ccaa::Position& position);
  void
  split(Leaves::iterator leaf);
  void
  append(const char* entry, const pcl::ccaa::Position& position);
  void
  flush(Leaf& leaf);
  void
  flushAll();
  std::vector<char>
  readLeaf(const Leaf& leaf) const;

  std::string folder_;
  std::size_t record_bytes_;
  pcl::ccaa::PointView records_;
  std::uint64_t most_points_;
  Leaves leaves_;
  Leaves::iterator last_;
  std::map<int, std::size_t> levels_; /**< of leaves, with their number */
  std::set<pcl::ccaa::GridCell> split_;
  std::size_t waiting_ = 0; /**< bytes in all leaves */
  std::vector<char> entry_, nowhere_;
};

} // namespace app
