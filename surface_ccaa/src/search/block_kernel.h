// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the border between the search and its compiled kernels.
#pragma once

#include <cstddef>
#include <cstdint>

// Only plain data crosses here: the other side is compiled for several instruction
// sets, and no inline function of a library may be compiled there and then be picked by
// the linker for everybody.

namespace pcl::ccaa::block_kernel {

/** Width of everything: points per block, boxes per group, queries per round. */
constexpr unsigned int LANES = 8;
constexpr unsigned int BLOCK_FLOATS = 3 * LANES;
constexpr unsigned int GROUP_FLOATS = 6 * LANES;

/** The arrays of PointBlocks (see there). */
struct BlockView {
  const float* coordinates;
  /** One array of box groups per level; the one at \a top has a single group. */
  const float* const* boxes;
  unsigned int top;
  std::uint32_t blocks;
  /** Number of points; the lanes of the last block beyond them hold NaN. */
  std::uint32_t size;
};

/** Working memory of one thread for one k. */
struct Scratch {
  /** Candidates per query; a multiple of LANES, at least k + 2 LANES. */
  unsigned int capacity;
  /** Blocks that are looked at to bound the distance of the k-th neighbor. */
  unsigned int window_blocks;
  /** LANES rows of capacity: candidates of each query, in the order of their ranks as
   * far as they are equally far. */
  float* distances;
  std::int32_t* ranks;
  /** Room to sort one row. */
  std::int32_t* places;
  float* sorted_distances;
  std::int32_t* sorted_ranks;
  /** LANES * LANES * window_blocks distances. */
  float* window;
};

/** A search that can stop when its room is full, and go on. */
struct RangeCursor {
  float query[3];
  float max_sqr_distance;
  /** Where to go on; view.blocks when done. */
  std::uint32_t next_block;
};

/** What a kernel can do, once per instruction set. */
struct Kernel {
  /** The k nearest neighbors of the points of a block, rows of k from \a ranks on;
   * \a sqr_distances may be null. Points that do not exist get no row. */
  void (*nearestOfBlock)(const BlockView& view,
                         const Scratch& scratch,
                         std::uint32_t block,
                         unsigned int k,
                         std::int32_t* ranks,
                         float* sqr_distances);
  /** The k nearest points to a place; returns how many there are within the distance.
   */
  unsigned int (*nearestOfPlace)(const BlockView& view,
                                 const Scratch& scratch,
                                 const float* query,
                                 float max_sqr_distance,
                                 unsigned int k,
                                 std::int32_t* ranks,
                                 float* sqr_distances);
  /** Points within a distance, until done or fewer than LANES of \a capacity are free;
   * returns how many were written. */
  unsigned int (*within)(const BlockView& view,
                         RangeCursor& cursor,
                         unsigned int capacity,
                         std::int32_t* ranks,
                         float* sqr_distances);
};

extern const Kernel BASELINE_KERNEL;
#if defined(__x86_64__) && (defined(__GNUC__) || defined(__clang__))
#define PCL_CCAA_HAS_AVX2_KERNEL
extern const Kernel AVX2_KERNEL;
#endif

/** Sort a long row of candidates by distance; equal ones keep their order. Compiled
 * once, for all kernels. Distances are not negative. */
void
sortLongRow(float* distances, std::int32_t* ranks, unsigned int size);

} // namespace pcl::ccaa::block_kernel
