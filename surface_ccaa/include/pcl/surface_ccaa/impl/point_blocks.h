// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: exact neighbor search over blocks of eight points.
#pragma once

#include <pcl/surface_ccaa/impl/point_array.h>

#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace pcl::ccaa {

class RunControl;

namespace block_kernel {
struct BlockView;
struct Scratch;
} // namespace block_kernel

/** \brief The k nearest neighbors of every point, one row per rank.
 *
 * Its memory is not initialised before the search writes it, so that each thread
 * touches its own rows first. */
class NeighborTable {
public:
  /** \brief Entry where a row has fewer than k neighbors; always at the row's end. */
  static constexpr index_t NONE = -1;

  NeighborTable() = default;
  NeighborTable(std::size_t rows, unsigned int k, bool with_distances);

  std::size_t
  rows() const
  {
    return rows_;
  }

  /** \brief Length of a row. */
  unsigned int
  k() const
  {
    return k_;
  }

  /** \brief Ranks of the neighbors of the point of this rank, nearest first. */
  const index_t*
  row(std::size_t rank) const
  {
    return ranks_.get() + rank * k_;
  }

  /** \brief Squared distances to row(rank), in squared units of the cloud; infinite
   * where the row holds NONE. Only if the table was made with distances. */
  const float*
  sqrDistances(std::size_t rank) const
  {
    return sqr_distances_.get() + rank * k_;
  }

private:
  friend class PointBlocks;

  std::size_t rows_ = 0;
  unsigned int k_ = 0;
  std::unique_ptr<index_t[]> ranks_;
  std::unique_ptr<float[]> sqr_distances_;
};

/** \brief A point found by a search. */
struct Neighbor {
  /** \brief Index in the array that PointBlocks was built from. */
  index_t point_index;
  /** \brief Squared distance to the query, in squared units of the cloud. */
  float sqr_distance;
};

/** \brief Points in curve order, packed in blocks of eight under a tree of boxes.
 *
 * Made for one job: the k nearest neighbors of all points at once. Eight neighbors on
 * the curve are searched together; they share one walk down the tree, and each box or
 * point test does eight at a time. Blocks are cut by location, not by count of cells,
 * so the density may vary at will.
 *
 * The rank of a point is its place in order(). Everything about all points speaks of
 * ranks (rows of neighboring ranks are neighboring memory); everything about one query
 * speaks of the caller's indices.
 *
 * Results are exact for distances in single precision, the sum of squared coordinate
 * differences as FLANN computes it, and the same for any number of threads and any
 * instruction set. Const calls may run in parallel.
 */
class PointBlocks {
public:
  /** \brief Points per block, the width of the widest instruction set in use. */
  static constexpr std::size_t BLOCK_SIZE = 8;

  /** \brief Instruction set to compute with; the results are the same. */
  enum class Instructions {
    /** The best that we have a kernel for and the processor runs. */
    BEST,
    /** What any processor of the family runs; to check the others against. */
    BASELINE
  };

  /** \brief Default BEST. */
  void
  setInstructions(Instructions instructions)
  {
    instructions_ = instructions;
  }

  /** \brief Take the points in; the array is not needed afterwards.
   *
   * Points with a NaN or infinite coordinate are left out. Cost O(N); keeps 20 bytes
   * per point and needs 36 more while it runs. \param[in] points the coordinates
   * \param[in] threads number of threads, 0: all */
  void
  build(const PointArray& points, int threads);

  /** \brief The same for chosen points only.
   * \param[in] points the coordinates
   * \param[in] selection indices into \a points
   * \param[in] threads number of threads, 0: all */
  void
  build(const PointArray& points, const Indices& selection, int threads);

  /** \brief The same for points whose order along a curve is known already, such as the
   * result of curveOrder() or removeDuplicates(). All of them must be finite. */
  void
  buildFromOrder(const PointArray& points, std::vector<index_t> order, int threads);

  /** \brief Number of finite points taken in. */
  std::size_t
  size() const
  {
    return order_.size();
  }

  /** \brief The caller's index of the point of each rank. */
  const std::vector<index_t>&
  order() const
  {
    return order_;
  }

  /** \brief Coordinates of the point of this rank. */
  std::array<float, 3>
  point(std::size_t rank) const
  {
    const float* x =
        &coordinates_[rank / BLOCK_SIZE * 3 * BLOCK_SIZE + rank % BLOCK_SIZE];
    return {x[0], x[BLOCK_SIZE], x[2 * BLOCK_SIZE]};
  }

  /** \brief Whether allNearest() keeps the squared distances as well. */
  enum class Distances { OMIT, KEEP };

  /** \brief The k nearest neighbors of every point, itself not among them.
   *
   * Rows ascend by squared distance, then by rank, and where more points are equally
   * far than a row has room for, those of the lowest rank are in it. Polls \a control
   * and reports the stage "neighbors" to it. \param[in] k neighbors per point, at least
   * 1 \param[in] distances whether the table holds squared distances too \param[in]
   * threads number of threads, at least 1 \param[in,out] control stops the search
   * early; may be null \return nothing when the run was cancelled */
  std::optional<NeighborTable>
  allNearest(unsigned int k,
             Distances distances,
             int threads,
             RunControl* control = nullptr) const;

  /** \brief The nearest points to a place.
   *
   * Ascending by squared distance, then by index. Where more points are equally far
   * than there is room for, those of the lowest rank are in. \param[in] query the
   * place; nothing is found around a non-finite one \param[in] k how many at most
   * \param[in] max_sqr_distance points farther than this are left out */
  std::vector<Neighbor>
  nearest(const std::array<float, 3>& query,
          std::size_t k,
          float max_sqr_distance = std::numeric_limits<float>::infinity()) const;

  /** \brief All points up to a distance from a place, ascending by squared distance,
   * then by index. \param[in] query the place; nothing is found around a non-finite one
   * \param[in] max_sqr_distance squared radius; points exactly so far are in */
  std::vector<Neighbor>
  within(const std::array<float, 3>& query, float max_sqr_distance) const;

private:
  /** Rows of the points of some blocks, one task of a thread. */
  void
  fillRows(NeighborTable& table,
           const block_kernel::BlockView& view,
           const block_kernel::Scratch& scratch,
           std::size_t first_block) const;

  void
  fillBlocks(const PointArray& points, int threads);

  void
  buildBoxes(int threads);

  Instructions instructions_ = Instructions::BEST;
  std::vector<index_t> order_;
  /** Block b: x of its eight points, then y, then z, from 24 b. NaN after the last. */
  std::vector<float> coordinates_;
  /** Level 0 bounds blocks, level l bounds groups of level l - 1. Group g: low x of
   * eight boxes, low y, low z, high x, high y, high z, from 48 g. NaN after the last.
   */
  std::vector<std::vector<float>> boxes_;
};

} // namespace pcl::ccaa
