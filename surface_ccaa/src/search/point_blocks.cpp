// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: exact neighbor search over blocks of eight points.
#include <pcl/surface_ccaa/search/point_blocks.h>
#include <pcl/surface_ccaa/threads.h>

#include "block_kernel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace ccaa {

namespace {

static_assert(sizeof(index_t) == sizeof(std::int32_t), "kernels write 32-bit ranks");
static_assert(PointBlocks::BLOCK_SIZE == search::LANES, "kernels are built for blocks");

using search::BLOCK_FLOATS;
using search::GROUP_FLOATS;
using search::LANES;

constexpr float NOT_A_NUMBER = std::numeric_limits<float>::quiet_NaN();
/** Blocks that a thread takes at a time: a few milliseconds of work. */
constexpr std::size_t BLOCKS_PER_TASK = 256;

const search::Kernel&
kernelFor(PointBlocks::Instructions instructions)
{
  if (instructions == PointBlocks::Instructions::BASELINE)
    return search::BASELINE_KERNEL;
#ifdef PCL_CCAA_HAS_AVX2_KERNEL
  static const bool has_avx2 = __builtin_cpu_supports("avx2") &&
                               __builtin_cpu_supports("popcnt") &&
                               __builtin_cpu_supports("bmi");
  if (has_avx2)
    return search::AVX2_KERNEL;
#endif
  return search::BASELINE_KERNEL;
}

std::size_t
roundUp(std::size_t size)
{
  return (size + LANES - 1) / LANES * LANES;
}

/** Owner of a thread's working memory. */
class ScratchMemory {
public:
  ScratchMemory(std::size_t k, std::size_t blocks, std::size_t rows)
  {
    const std::size_t capacity = roundUp(2 * k) + 4 * LANES;
    const std::size_t window_blocks = std::min(blocks, 3 * k / LANES + 3);
    const std::size_t window = window_blocks * LANES * LANES;
    floats_.reset(new float[(rows + 1) * capacity + window]);
    ranks_.reset(new std::int32_t[(rows + 2) * capacity]);
    view_.capacity = static_cast<unsigned int>(capacity);
    view_.window_blocks = static_cast<unsigned int>(window_blocks);
    view_.distances = floats_.get();
    view_.sorted_distances = view_.distances + rows * capacity;
    view_.window = view_.sorted_distances + capacity;
    view_.ranks = ranks_.get();
    view_.sorted_ranks = view_.ranks + rows * capacity;
    view_.places = view_.sorted_ranks + capacity;
  }

  const search::Scratch&
  view() const
  {
    return view_;
  }

private:
  search::Scratch view_{};
  std::unique_ptr<float[]> floats_;
  std::unique_ptr<std::int32_t[]> ranks_;
};

/** The plain arrays of PointBlocks, as the kernels want them. */
class View {
public:
  View(const std::vector<float>& coordinates,
       const std::vector<std::vector<float>>& boxes,
       std::size_t size)
  {
    for (std::size_t level = 0; level < boxes.size(); ++level)
      levels_[level] = boxes[level].data();
    view_.coordinates = coordinates.data();
    view_.boxes = levels_.data();
    view_.top = static_cast<unsigned int>(boxes.size() - 1);
    view_.blocks = static_cast<std::uint32_t>(coordinates.size() / BLOCK_FLOATS);
    view_.size = static_cast<std::uint32_t>(size);
  }

  View(const View&) = delete;
  View&
  operator=(const View&) = delete;

  const search::BlockView&
  operator*() const
  {
    return view_;
  }

private:
  /** 8 to the power of 12 exceeds what an index can count. */
  std::array<const float*, 12> levels_{};
  search::BlockView view_{};
};

bool
isFinite(const std::array<float, 3>& query)
{
  return std::isfinite(query[0]) && std::isfinite(query[1]) && std::isfinite(query[2]);
}

std::vector<Neighbor>
sortedNeighbors(const std::vector<index_t>& order,
                const std::vector<index_t>& ranks,
                const std::vector<float>& sqr_distances,
                std::size_t size)
{
  std::vector<Neighbor> neighbors(size);
  for (std::size_t i = 0; i < size; ++i)
    neighbors[i] = {order[static_cast<std::size_t>(ranks[i])], sqr_distances[i]};
  std::sort(
      neighbors.begin(), neighbors.end(), [](const Neighbor& a, const Neighbor& b) {
        return a.sqr_distance != b.sqr_distance ? a.sqr_distance < b.sqr_distance
                                                : a.point_index < b.point_index;
      });
  return neighbors;
}

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
  buildFromOrder(points, curveOrder(points, threads), threads);
}

void
PointBlocks::build(const PointArray& points, const Indices& selection, int threads)
{
  buildFromOrder(points, curveOrder(points, selection, threads), threads);
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
  const std::size_t padded = roundUp(size());
  coordinates_.resize(padded * 3);
#pragma omp parallel for num_threads(threads) schedule(static)
  for (std::size_t rank = 0; rank < padded; ++rank) {
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

std::optional<NeighborTable>
PointBlocks::allNearest(unsigned int k,
                        Distances distances,
                        int threads,
                        RunControl* control) const
{
  NeighborTable table(size(), k, distances == Distances::KEEP);
  const View view(coordinates_, boxes_, size());
  const std::size_t blocks = (*view).blocks;
  const auto tasks =
      static_cast<std::ptrdiff_t>((blocks + BLOCKS_PER_TASK - 1) / BLOCKS_PER_TASK);
#pragma omp parallel num_threads(threads)
  {
    const ScratchMemory scratch(std::min<std::size_t>(k, size()), blocks, LANES);
#pragma omp for schedule(dynamic)
    for (std::ptrdiff_t task = 0; task < tasks; ++task) {
      if (control != nullptr && control->cancelled())
        continue;
      const auto begin = static_cast<std::size_t>(task) * BLOCKS_PER_TASK;
      const std::size_t end = std::min(begin + BLOCKS_PER_TASK, blocks);
      for (std::size_t block = begin; block < end; ++block) {
        const std::size_t row = block * LANES * k;
        float* const sqr_distances = table.sqr_distances_.get();
        kernelFor(instructions_)
            .nearestOfBlock(*view,
                            scratch.view(),
                            static_cast<std::uint32_t>(block),
                            k,
                            table.ranks_.get() + row,
                            sqr_distances ? sqr_distances + row : nullptr);
      }
      if (control != nullptr && threadIndex() == 0)
        control->report("neighbors", double(end) / double(blocks));
    }
  }
  if (control != nullptr && control->cancelled())
    return std::nullopt;
  return table;
}

std::vector<Neighbor>
PointBlocks::nearest(const std::array<float, 3>& query,
                     std::size_t k,
                     float max_sqr_distance) const
{
  k = std::min(k, size());
  if (k == 0 || !isFinite(query))
    return {};
  const View view(coordinates_, boxes_, size());
  const ScratchMemory scratch(k, (*view).blocks, 1);
  std::vector<index_t> ranks(k);
  std::vector<float> sqr_distances(k);
  const unsigned int found = kernelFor(instructions_)
                                 .nearestOfPlace(*view,
                                                 scratch.view(),
                                                 query.data(),
                                                 max_sqr_distance,
                                                 static_cast<unsigned int>(k),
                                                 ranks.data(),
                                                 sqr_distances.data());
  return sortedNeighbors(order_, ranks, sqr_distances, found);
}

std::vector<Neighbor>
PointBlocks::within(const std::array<float, 3>& query, float max_sqr_distance) const
{
  if (size() == 0 || !isFinite(query))
    return {};
  const View view(coordinates_, boxes_, size());
  search::RangeCursor cursor{{query[0], query[1], query[2]}, max_sqr_distance, 0};
  std::vector<index_t> ranks;
  std::vector<float> sqr_distances;
  std::size_t found = 0;
  while (cursor.next_block < (*view).blocks) {
    const std::size_t room = std::max<std::size_t>(128, found);
    ranks.resize(found + room);
    sqr_distances.resize(found + room);
    found += kernelFor(instructions_)
                 .within(*view,
                         cursor,
                         static_cast<unsigned int>(room),
                         ranks.data() + found,
                         sqr_distances.data() + found);
  }
  return sortedNeighbors(order_, ranks, sqr_distances, found);
}

namespace search {

void
sortLongRow(float* distances, std::int32_t* ranks, unsigned int size)
{
  struct Entry {
    float distance;
    std::int32_t rank;
  };
  std::vector<Entry> entries(size);
  for (unsigned int i = 0; i < size; ++i)
    entries[i] = {distances[i], ranks[i]};
  std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return a.distance < b.distance;
  });
  for (unsigned int i = 0; i < size; ++i) {
    distances[i] = entries[i].distance;
    ranks[i] = entries[i].rank;
  }
}

} // namespace search

} // namespace ccaa
} // namespace pcl
