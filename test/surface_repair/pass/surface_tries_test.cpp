// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of changes that are tried side by side.

#include <gtest/gtest.h>

#include "pass/surface_tries.h"
#include "support/random_source.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace pcl::repair {
namespace {

/** What a change would write where it looked, cells of a row. */
struct Sum {
  std::size_t begin, end;
  std::uint64_t value;
  ccaa::Box seen;
};

constexpr std::size_t CELLS = 40;
constexpr std::size_t CHANGES = 300;

ccaa::Box
boxOfCells(std::size_t begin, std::size_t end)
{
  return {ccaa::Position(static_cast<double>(begin), 0.0, 0.0),
          ccaa::Position(static_cast<double>(end) - 0.5, 0.0, 0.0)};
}

/** Each change reads some cells and writes a sum of them, or nothing. */
std::vector<std::uint64_t>
cellsAfter(std::uint64_t seed, int threads)
{
  std::vector<std::uint64_t> cells(CELLS);
  std::iota(cells.begin(), cells.end(), std::uint64_t{1});
  const auto sumOf = [&](std::size_t i, const ccaa::LoopContext&) {
    ccaa::test::RandomSource random(1000 * seed + i);
    const std::size_t begin = random.below(CELLS);
    const std::size_t end = std::min(CELLS, begin + 1 + random.below(6));
    std::uint64_t value = i;
    for (std::size_t c = begin; c < end; ++c)
      value = 31 * value + cells[c];
    return Sum{begin, end, value, boxOfCells(begin, end)};
  };
  const auto write = [&](std::size_t, const Sum& sum) {
    if (sum.value % 3 == 0)
      return ccaa::Box();
    for (std::size_t c = sum.begin; c < sum.end; ++c)
      cells[c] += sum.value;
    return sum.seen;
  };
  makeInTurn(CHANGES, ccaa::LoopContext{threads}, sumOf, write);
  return cells;
}

TEST(MakeInTurn, MakesWhatOneAfterTheOtherWouldBeForAnyNumberOfThreads)
{
  for (std::uint64_t seed = 0; seed < 20; ++seed)
    for (const int threads : {2, 5})
      EXPECT_EQ(cellsAfter(seed, 1), cellsAfter(seed, threads)) << seed;
}

TEST(MakeInTurn, PassesOnWhatATryThrows)
{
  const auto tryOut = [](std::size_t i, const ccaa::LoopContext&) {
    if (i == 7)
      throw std::runtime_error("seven");
    return Sum{};
  };
  std::size_t made = 0;
  const auto make = [&](std::size_t, const Sum&) {
    ++made;
    return ccaa::Box();
  };
  for (const int threads : {1, 2}) {
    made = 0;
    EXPECT_THROW(makeInTurn(20, ccaa::LoopContext{threads}, tryOut, make),
                 std::runtime_error);
    EXPECT_EQ(7U, made);
  }
}

} // namespace
} // namespace pcl::repair
