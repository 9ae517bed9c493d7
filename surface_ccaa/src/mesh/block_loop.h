// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: parallel loops in blocks that report and can be cancelled.
#pragma once

#include "run/run_control.h"
#include "run/threads.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <thread>
#include <vector>

namespace pcl::ccaa {

/** \brief Items a block holds: some milliseconds of work at most, so that a run stops
 * soon after it was cancelled, and enough that threads seldom meet. */
constexpr std::size_t BLOCK_SIZE = 16384;

/** \brief How a loop runs: how many threads, and whom it tells about its progress. */
struct LoopContext {
  int threads = 1;                     /**< at least 1 */
  RunControl* control = nullptr;       /**< none: neither progress nor cancelling */
  const char* stage = "";              /**< of the progress callback */
  std::size_t block_size = BLOCK_SIZE; /**< smaller where one item is much work */

  bool
  cancelled() const
  {
    return control != nullptr && control->cancelled();
  }

  /** \brief Number of blocks for so many items. */
  std::size_t
  blockCount(std::size_t count) const
  {
    return (count + block_size - 1) / block_size;
  }
};

/** \brief Wait until other threads have done what is left, and ask meanwhile whether
 * the run goes on. */
inline void
waitForOthers(const std::atomic<std::ptrdiff_t>& left, RunControl& control)
{
  constexpr int yields = 64, naps_a_question = 64;
  for (int round = 0; left.load(std::memory_order_acquire) > 0; ++round)
    if (round < yields)
      std::this_thread::yield();
    else {
      std::this_thread::sleep_for(std::chrono::microseconds(100));
      if (round % naps_a_question == 0)
        control.askAgain();
    }
}

/** \brief Call body(block, begin, end) for all blocks of [0, count). Blocks run in any
 * order, so they must not depend on each other; after cancelling the rest is left out.
 * \return false when cancelled */
template <typename Body>
bool
forEachBlock(std::size_t count, const LoopContext& context, const Body& body)
{
  const auto blocks = static_cast<std::ptrdiff_t>(context.blockCount(count));
  std::atomic<std::ptrdiff_t> left{blocks};
  const auto doBlock = [&](std::ptrdiff_t i) {
    const auto block = static_cast<std::size_t>(i);
    const std::size_t begin = block * context.block_size;
    body(block, begin, std::min(begin + context.block_size, count));
    if (context.control != nullptr && threadIndex() == 0)
      context.control->report(context.stage,
                              static_cast<double>(i + 1) / static_cast<double>(blocks));
  };
#pragma omp parallel num_threads(context.threads) if (context.threads > 1 && blocks > 1)
  {
#pragma omp for schedule(dynamic) nowait
    for (std::ptrdiff_t i = 0; i < blocks; ++i) {
      if (!context.cancelled())
        doBlock(i);
      left.fetch_sub(1, std::memory_order_release);
    }
    if (context.control != nullptr && threadIndex() == 0)
      waitForOthers(left, *context.control);
  }
  return !context.cancelled();
}

/** \brief Split [0, count) into one range a thread and show every range all blocks of
 * [0, items): body(first, last, begin, end) handles what the items [begin, end) do to
 * [first, last). For writing through indices: no two threads share a target, and each
 * target sees the items in ascending order.
 * \return false when cancelled */
template <typename Body>
bool
forEachRange(std::size_t count,
             std::size_t items,
             const LoopContext& context,
             const Body& body)
{
  const int ranges = context.threads;
  const auto bound = [&](int range) {
    return count * static_cast<std::size_t>(range) / static_cast<std::size_t>(ranges);
  };
#pragma omp parallel for schedule(static) num_threads(ranges) if (ranges > 1)
  for (int range = 0; range < ranges; ++range)
    for (std::size_t begin = 0; begin < items; begin += context.block_size) {
      if (context.cancelled())
        break;
      const std::size_t end = std::min(begin + context.block_size, items);
      body(bound(range), bound(range + 1), begin, end);
      if (context.control != nullptr && threadIndex() == 0)
        context.control->report(context.stage,
                                static_cast<double>(end) / static_cast<double>(items));
    }
  return !context.cancelled();
}

/** \brief How many flags of a range are 1. */
inline std::size_t
countOf(const std::vector<std::uint8_t>& flags, std::size_t begin, std::size_t end)
{
  const auto first = flags.begin();
  return static_cast<std::size_t>(std::count(first + static_cast<std::ptrdiff_t>(begin),
                                             first + static_cast<std::ptrdiff_t>(end),
                                             std::uint8_t{1}));
}

/** \brief The same of all. */
inline std::size_t
countOf(const std::vector<std::uint8_t>& flags)
{
  return countOf(flags, 0, flags.size());
}

/** \brief Where what each block yields begins among all of it; the last entry is how
 * much that is.
 * \param[in] yieldOf how much items [begin, end) do: yieldOf(begin, end) */
template <typename YieldOf>
std::vector<std::size_t>
blockStarts(std::size_t count, const LoopContext& context, const YieldOf& yieldOf)
{
  std::vector<std::size_t> starts(context.blockCount(count) + 1, 0);
  forEachBlock(
      count, context, [&](std::size_t block, std::size_t begin, std::size_t end) {
        starts[block + 1] = yieldOf(begin, end);
      });
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  return starts;
}

/** \brief Join what each block has collected, in block order, so that the result does
 * not depend on the number of threads. */
template <typename T>
std::vector<T>
joinBlocks(const std::vector<std::vector<T>>& parts)
{
  std::size_t count = 0;
  for (const auto& part : parts)
    count += part.size();
  std::vector<T> all;
  all.reserve(count);
  for (const auto& part : parts)
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

} // namespace pcl::ccaa
