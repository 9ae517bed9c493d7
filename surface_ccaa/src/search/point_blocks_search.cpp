// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: exact neighbor search over blocks of eight points.
#include <pcl/surface_ccaa/impl/point_blocks.h>

#include "run/run_control.h"
#include "run/threads.h"
#include "search/block_kernel.h"

#include <algorithm>
#include <cmath>

namespace pcl::ccaa {

namespace {

using block_kernel::BLOCK_FLOATS;
using block_kernel::LANES;

static_assert(sizeof(index_t) == sizeof(std::int32_t), "kernels write 32-bit ranks");

/** Blocks that a thread takes at a time: a few milliseconds of work. */
constexpr std::size_t BLOCKS_PER_TASK = 256;

const block_kernel::Kernel&
kernelFor(PointBlocks::Instructions instructions)
{
  if (instructions == PointBlocks::Instructions::BASELINE)
    return block_kernel::BASELINE_KERNEL;
#ifdef PCL_CCAA_HAS_AVX2_KERNEL
  static const bool has_avx2 = __builtin_cpu_supports("avx2") &&
                               __builtin_cpu_supports("popcnt") &&
                               __builtin_cpu_supports("bmi");
  if (has_avx2)
    return block_kernel::AVX2_KERNEL;
#endif
  return block_kernel::BASELINE_KERNEL;
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

  const block_kernel::Scratch&
  view() const
  {
    return view_;
  }

private:
  block_kernel::Scratch view_{};
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

  const block_kernel::BlockView&
  operator*() const
  {
    return view_;
  }

private:
  /** 8 to the power of 12 exceeds what an index can count. */
  std::array<const float*, 12> levels_{};
  block_kernel::BlockView view_{};
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

} // namespace

void
PointBlocks::fillRows(NeighborTable& table,
                      const block_kernel::BlockView& view,
                      const block_kernel::Scratch& scratch,
                      std::size_t first_block) const
{
  const std::size_t end =
      std::min<std::size_t>(first_block + BLOCKS_PER_TASK, view.blocks);
  for (std::size_t block = first_block; block < end; ++block) {
    const std::size_t row = block * LANES * table.k_;
    float* const sqr_distances = table.sqr_distances_.get();
    kernelFor(instructions_)
        .nearestOfBlock(view,
                        scratch,
                        static_cast<std::uint32_t>(block),
                        table.k_,
                        table.ranks_.get() + row,
                        sqr_distances ? sqr_distances + row : nullptr);
  }
}

std::optional<NeighborTable>
PointBlocks::allNearest(unsigned int k,
                        Distances distances,
                        int threads,
                        RunControl* control) const
{
  NeighborTable table(size(), k, distances == Distances::KEEP);
  const View view(coordinates_, boxes_, size());
  const std::size_t blocks = k == 0 ? 0 : (*view).blocks;
  const auto is_cancelled = [control]() { return control && control->cancelled(); };
  std::vector<ScratchMemory> scratch;
  for (int i = 0; i < threads; ++i)
    scratch.emplace_back(std::min<std::size_t>(k, size()), blocks, LANES);
#pragma omp parallel for num_threads(threads) schedule(dynamic)
  for (std::size_t block = 0; block < blocks; block += BLOCKS_PER_TASK) {
    if (is_cancelled())
      continue;
    const auto thread = static_cast<std::size_t>(threadIndex());
    fillRows(table, *view, scratch[thread].view(), block);
    if (control && thread == 0)
      control->report("neighbors",
                      double(std::min(block + BLOCKS_PER_TASK, blocks)) /
                          double(blocks));
  }
  if (is_cancelled())
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
  block_kernel::RangeCursor cursor{{query[0], query[1], query[2]}, max_sqr_distance, 0};
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

namespace block_kernel {

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

} // namespace block_kernel

} // namespace pcl::ccaa
