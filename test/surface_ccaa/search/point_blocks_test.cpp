// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of the exact neighbor search over blocks.
#include <gtest/gtest.h>

#include "mesh/curve_order.h"
#include "run/run_control.h"
#include "search_inputs.h"

namespace pcl::ccaa::test {
namespace {

constexpr auto KEEP = PointBlocks::Distances::KEEP;
constexpr auto OMIT = PointBlocks::Distances::OMIT;

PointBlocks
blocksOf(const Coordinates& coordinates, int threads = 1)
{
  PointBlocks blocks;
  blocks.build(arrayOf(coordinates), threads);
  return blocks;
}

std::vector<index_t>
entries(const NeighborTable& table)
{
  return {table.row(0), table.row(table.rows())};
}

/** Row as the table should have it, from all points sorted by distance and rank. */
void
expectRow(const NeighborTable& table,
          std::size_t rank,
          std::vector<std::pair<float, index_t>> expected)
{
  const auto self = [rank](const std::pair<float, index_t>& entry) {
    return entry.second == static_cast<index_t>(rank);
  };
  expected.erase(std::find_if(expected.begin(), expected.end(), self));
  const float none = std::numeric_limits<float>::infinity();
  expected.resize(table.k(), {none, NeighborTable::NONE});
  for (std::size_t i = 0; i < table.k(); ++i) {
    ASSERT_EQ(table.row(rank)[i], expected[i].second) << "rank " << rank << ", " << i;
    ASSERT_EQ(table.sqrDistances(rank)[i], expected[i].first) << "rank " << rank;
  }
}

void
expectBruteForce(const PointBlocks& blocks, unsigned int k)
{
  const auto table = blocks.allNearest(k, KEEP, 1);
  ASSERT_TRUE(table);
  ASSERT_EQ(table->rows(), blocks.size());
  const std::size_t step = 1 + blocks.size() / 150;
  for (std::size_t rank = 0; rank < blocks.size(); rank += step)
    ASSERT_NO_FATAL_FAILURE(
        expectRow(*table, rank, bruteForce(blocks, blocks.point(rank))));
}

class AllInputs : public ::testing::TestWithParam<NamedInput> {
protected:
  const PointBlocks blocks_ = blocksOf(GetParam().coordinates);
};

INSTANTIATE_TEST_SUITE_P(PointBlocks,
                         AllInputs,
                         ::testing::ValuesIn(allInputs()),
                         [](const auto& input) { return input.param.name; });

TEST_P(AllInputs, AllNearestIsBruteForce)
{
  for (const unsigned int k : {1u, 7u, 16u, 64u, 200u})
    ASSERT_NO_FATAL_FAILURE(expectBruteForce(blocks_, k)) << "k = " << k;
}

TEST_P(AllInputs, AllNearestIsTheSameForAnyNumberOfThreads)
{
  const auto one = blocks_.allNearest(16, OMIT, 1);
  for (const int threads : {2, 7}) {
    const PointBlocks same = blocksOf(GetParam().coordinates, threads);
    EXPECT_EQ(same.order(), blocks_.order());
    EXPECT_EQ(entries(*same.allNearest(16, OMIT, threads)), entries(*one));
  }
}

TEST_P(AllInputs, AllNearestIsTheSameForAnyInstructionSet)
{
  PointBlocks baseline = blocks_;
  baseline.setInstructions(PointBlocks::Instructions::BASELINE);
  for (const unsigned int k : {3u, 16u, 200u}) {
    const auto a = blocks_.allNearest(k, KEEP, 1);
    const auto b = baseline.allNearest(k, KEEP, 1);
    EXPECT_EQ(entries(*a), entries(*b));
    EXPECT_TRUE(
        std::equal(a->sqrDistances(0), a->sqrDistances(a->rows()), b->sqrDistances(0)));
  }
}

TEST_P(AllInputs, NearestHasTheDistancesOfBruteForce)
{
  const std::size_t step = 1 + blocks_.size() / 100;
  for (std::size_t rank = 0; rank < blocks_.size(); rank += step) {
    const auto query = blocks_.point(rank);
    const auto expected = bruteForce(blocks_, query);
    const auto found = blocks_.nearest(query, 20);
    ASSERT_EQ(found.size(), std::min<std::size_t>(20, blocks_.size()));
    for (std::size_t i = 0; i < found.size(); ++i)
      ASSERT_EQ(found[i].sqr_distance, expected[i].first);
  }
}

TEST_P(AllInputs, WithinIsBruteForce)
{
  const std::size_t step = 1 + blocks_.size() / 50;
  for (std::size_t rank = 0; rank < blocks_.size(); rank += step) {
    const auto query = blocks_.point(rank);
    auto expected = bruteForce(blocks_, query);
    const float limit = expected[expected.size() / 3].first;
    for (auto& [sqr_distance, index] : expected)
      index = blocks_.order()[static_cast<std::size_t>(index)];
    std::sort(expected.begin(), expected.end());
    const auto found = blocks_.within(query, limit);
    for (std::size_t i = 0; i < found.size(); ++i)
      ASSERT_EQ(found[i].point_index, expected[i].second);
    ASSERT_TRUE(found.size() == expected.size() ||
                expected[found.size()].first > limit);
  }
}

TEST_P(AllInputs, KeepsCoordinatesByRank)
{
  const PointArray points = arrayOf(GetParam().coordinates);
  for (std::size_t rank = 0; rank < blocks_.size(); ++rank)
    for (std::size_t axis = 0; axis < 3; ++axis)
      ASSERT_EQ(blocks_.point(rank)[axis], points[blocks_.order()[rank]][axis]);
}

TEST(PointBlocks, NearestFromPlacesOffTheCloud)
{
  const PointBlocks blocks = blocksOf(toCoordinates(noisySphere(3000, 0.01)));
  RandomSource random(8);
  for (int i = 0; i < 200; ++i) {
    const double scale = std::pow(10, random.uniform(-3, 3));
    const std::array<float, 3> query = {static_cast<float>(scale * random.normal()),
                                        static_cast<float>(scale * random.normal()),
                                        static_cast<float>(scale * random.normal())};
    const auto expected = bruteForce(blocks, query);
    const auto found = blocks.nearest(query, 12);
    ASSERT_EQ(found.size(), 12u);
    for (std::size_t j = 0; j < 12; ++j)
      ASSERT_EQ(found[j].sqr_distance, expected[j].first);
  }
}

TEST(PointBlocks, NearestStopsAtTheDistanceGiven)
{
  const PointBlocks blocks = blocksOf(toCoordinates(lattice(5)));
  EXPECT_EQ(blocks.nearest({2, 2, 2}, 50, 1.f).size(), 7u);
  EXPECT_EQ(blocks.nearest({2, 2, 2}, 3, 1.f).size(), 3u);
  EXPECT_TRUE(blocks.nearest({2, 2, 2}, 3, -1.f).empty());
}

TEST(PointBlocks, FindsNothingWhereThereIsNothing)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const PointBlocks never_built;
  EXPECT_TRUE(never_built.nearest({0, 0, 0}, 3).empty());
  EXPECT_TRUE(never_built.within({0, 0, 0}, 3.f).empty());
  EXPECT_EQ(never_built.allNearest(3, OMIT, 1)->rows(), 0u);
  const PointBlocks blocks = blocksOf(toCoordinates(lattice(3)));
  EXPECT_TRUE(blocks.nearest({nan, 0, 0}, 3).empty());
  EXPECT_TRUE(blocks.within({0, nan, 0}, 3.f).empty());
  EXPECT_TRUE(blocks.nearest({0, 0, 0}, 0).empty());
}

TEST(PointBlocks, CanBeBuiltAgain)
{
  PointBlocks blocks = blocksOf(toCoordinates(lattice(9)));
  const Coordinates other = toCoordinates(noisySphere(400, 0.01));
  blocks.build(arrayOf(other), 1);
  EXPECT_EQ(blocks.size(), 400u);
  EXPECT_NO_FATAL_FAILURE(expectBruteForce(blocks, 10));
}

TEST(PointBlocks, TakesAnOrderWithoutDuplicates)
{
  const Coordinates five = toCoordinates(withDuplicates(noisySphere(400, 0.01), 5));
  const PointArray points = arrayOf(five);
  PointBlocks blocks;
  blocks.buildFromOrder(points, removeDuplicates(points, curveOrder(points, 1)), 1);
  EXPECT_EQ(blocks.size(), 400u);
  EXPECT_NO_FATAL_FAILURE(expectBruteForce(blocks, 10));
}

TEST(PointBlocks, CopesWithAMillionIdenticalPoints)
{
  const PointBlocks blocks = blocksOf(Coordinates(3 * 1000000, 0.5f), 2);
  const auto table = blocks.allNearest(16, OMIT, 2);
  EXPECT_EQ(table->row(999999)[15], 15);
  EXPECT_EQ(blocks.nearest({0.5f, 0.5f, 0.5f}, 5).size(), 5u);
}

TEST(PointBlocks, CopesWithAllPointsInOneCellOfTheCurve)
{
  Positions points = bumpySphere(100000);
  points.push_back({1e30, 0, 0});
  const PointBlocks blocks = blocksOf(toCoordinates(points), 2);
  EXPECT_TRUE(blocks.allNearest(16, OMIT, 2));
}

TEST(PointBlocks, ReportsProgressAndStopsWhenToldTo)
{
  const PointBlocks blocks = blocksOf(toCoordinates(noisySphere(20000, 0.01)));
  double last = 0;
  RunControl watched([&last](const std::string& stage, double fraction) {
    EXPECT_EQ(stage, "neighbors");
    EXPECT_GE(fraction, last);
    last = fraction;
    return true;
  });
  EXPECT_TRUE(blocks.allNearest(16, OMIT, 1, &watched));
  EXPECT_EQ(last, 1.0);
  int calls = 0;
  RunControl stopped([&calls](const std::string&, double) { return ++calls < 2; });
  EXPECT_FALSE(blocks.allNearest(16, OMIT, 1, &stopped));
  EXPECT_EQ(calls, 2);
}

} // namespace
} // namespace pcl::ccaa::test
