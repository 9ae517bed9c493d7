// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: points packed in blocks under a tree of boxes.
#include <pcl/surface_ccaa/impl/point_blocks.h>

#include "mesh/curve_order.h"
#include "run/run_control.h"
#include "run/threads.h"
#include "search/block_kernel.h"

#include <algorithm>
#include <limits>

namespace pcl::ccaa {

namespace {

using block_kernel::BLOCK_FLOATS;
using block_kernel::GROUP_FLOATS;
using block_kernel::LANES;

static_assert(PointBlocks::BLOCK_SIZE == LANES, "kernels are built for blocks");

/** How many points ahead their coordinates, which lie anywhere, are asked for. */
constexpr std::size_t PREFETCH = 24;
constexpr float NOT_A_NUMBER = std::numeric_limits<float>::quiet_NaN();

/** Bounds of eight things with these boxes as one box, written to a lane of a group. */
void
boundGroup(const float* lows, const float* highs, std::size_t size, float* lane)
{
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float* const low = lows + axis * LANES;
    const float* const high = highs + axis * LANES;
    lane[axis * LANES] = *std::min_element(low, low + size);
    lane[(axis + 3) * LANES] = *std::max_element(high, high + size);
  }
}

} // namespace

NeighborTable::NeighborTable(std::size_t rows, unsigned int k, bool with_distances)
: rows_(rows)
, k_(k)
, ranks_(new index_t[rows * k])
, sqr_distances_(with_distances ? new float[rows * k] : nullptr)
{}

void
PointBlocks::build(const PointArray& points, int threads)
{
  const int used = resolveThreads(static_cast<unsigned int>(threads));
  buildFromOrder(points, curveOrder(points, used), used);
}

void
PointBlocks::build(const PointArray& points, const Indices& selection, int threads)
{
  const int used = resolveThreads(static_cast<unsigned int>(threads));
  buildFromOrder(points, curveOrder(points, selection, used), used);
}

void
PointBlocks::buildFromOrder(const PointArray& points,
                            std::vector<index_t> order,
                            int threads)
{
  order_ = std::move(order);
  fillBlocks(points, threads);
  buildBoxes(threads);
}

void
PointBlocks::fillBlocks(const PointArray& points, int threads)
{
  const std::size_t padded = (size() + LANES - 1) / LANES * LANES;
  coordinates_.resize(padded * 3);
#pragma omp parallel for num_threads(threads) schedule(static)
  for (std::size_t rank = 0; rank < padded; ++rank) {
    if (rank + PREFETCH < size())
      __builtin_prefetch(points[order_[rank + PREFETCH]]);
    float* const x = &coordinates_[rank / LANES * BLOCK_FLOATS + rank % LANES];
    for (std::size_t axis = 0; axis < 3; ++axis)
      x[axis * LANES] = rank < size() ? points[order_[rank]][axis] : NOT_A_NUMBER;
  }
}

void
PointBlocks::buildBoxes(int threads)
{
  boxes_.clear();
  std::size_t below = size();
  do {
    const std::size_t boxes = (below + LANES - 1) / LANES;
    const std::size_t groups = (boxes + LANES - 1) / LANES;
    std::vector<float> level(groups * GROUP_FLOATS, NOT_A_NUMBER);
    const bool of_blocks = boxes_.empty();
    const float* const from = of_blocks ? coordinates_.data() : boxes_.back().data();
    const std::size_t step = of_blocks ? BLOCK_FLOATS : GROUP_FLOATS;
#pragma omp parallel for num_threads(threads) schedule(static)
    for (std::size_t box = 0; box < boxes; ++box) {
      const float* const low = from + box * step;
      boundGroup(low,
                 of_blocks ? low : low + 3 * LANES,
                 std::min<std::size_t>(LANES, below - box * LANES),
                 &level[box / LANES * GROUP_FLOATS + box % LANES]);
    }
    boxes_.push_back(std::move(level));
    below = boxes;
  }
  while (below > LANES);
}

} // namespace pcl::ccaa
