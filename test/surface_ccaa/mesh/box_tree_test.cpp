// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of mesh/box_tree.h and
// mesh/packed_box_tree.h.
#include <gtest/gtest.h>

#include "mesh/box_tree.h"
#include "mesh/packed_box_tree.h"
#include "support/random_source.h"

#include <algorithm>

namespace pcl {
namespace ccaa {
namespace test {
namespace {

std::vector<Box>
randomBoxes(std::size_t count, std::uint64_t seed)
{
  RandomSource random(seed);
  std::vector<Box> boxes(count);
  for (Box& box : boxes) {
    const Position corner(random.uniform(), random.uniform(), random.uniform());
    const double size = 0.3 * random.uniform() * random.uniform();
    box = Box(corner, corner + Position::Constant(size));
  }
  return boxes;
}

std::vector<index_t>
found(const BoxTree& tree, const Box& query)
{
  std::vector<index_t> result;
  tree.forEachMeeting(query, [&](index_t index) { result.push_back(index); });
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<index_t>
foundOneByOne(const std::vector<Box>& boxes, const Box& query)
{
  std::vector<index_t> result;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    if (boxes[i].intersects(query))
      result.push_back(static_cast<index_t>(i));
  return result;
}

TEST(BoxOf, ReachesFromTheLowestToTheHighestCoordinates)
{
  const Box box = boxOf({Position(0, 5, 2), Position(3, 4, 1), Position(1, 6, 0)});
  EXPECT_EQ(box.min(), Position(0, 4, 0));
  EXPECT_EQ(box.max(), Position(3, 6, 2));
}

TEST(BoxTree, FindsWhatLookingAtEveryBoxFinds)
{
  for (const std::size_t count : {1u, 7u, 8u, 9u, 64u, 65u, 1000u}) {
    const std::vector<Box> boxes = randomBoxes(count, count);
    const BoxTree tree(boxes);
    for (const Box& query : randomBoxes(50, 99))
      EXPECT_EQ(found(tree, query), foundOneByOne(boxes, query));
  }
}

TEST(BoxTree, TheNearOnesHaveTheNearestAmongThem)
{
  const std::vector<Box> boxes = randomBoxes(500, 3);
  const BoxTree tree(boxes);
  for (const Box& query : randomBoxes(50, 99)) {
    double least = 0.3;
    std::size_t visits = 0;
    tree.forEachNear(query, least, [&](index_t index) {
      ++visits;
      const Box& box = boxes[static_cast<std::size_t>(index)];
      return least = std::min(least, box.squaredExteriorDistance(query));
    });
    double expected = 0.3;
    for (const Box& box : boxes)
      expected = std::min(expected, box.squaredExteriorDistance(query));
    EXPECT_EQ(expected, least);
    EXPECT_LT(visits, least > 0.0 ? 50U : boxes.size());
  }
}

TEST(BoxTree, NoneIsVisitedThatIsFurtherThanAsked)
{
  const std::vector<Box> boxes = randomBoxes(500, 3);
  const BoxTree tree(boxes);
  for (const Box& query : randomBoxes(50, 99)) {
    std::vector<index_t> near;
    tree.forEachNear(query, 0.04, [&](index_t index) {
      near.push_back(index);
      return 0.04;
    });
    std::sort(near.begin(), near.end());
    std::vector<index_t> expected;
    for (std::size_t i = 0; i < boxes.size(); ++i)
      if (boxes[i].squaredExteriorDistance(query) <= 0.04)
        expected.push_back(static_cast<index_t>(i));
    EXPECT_EQ(expected, near);
  }
}

TEST(BoxTree, TouchingCounts)
{
  const BoxTree tree({Box(Position(0, 0, 0), Position(1, 1, 1))});
  EXPECT_EQ(found(tree, Box(Position(1, 1, 1), Position(2, 2, 2))).size(), 1u);
}

TEST(BoxTree, NeverFindsEmptyBoxes)
{
  std::vector<Box> boxes = randomBoxes(20, 1);
  boxes[4].setEmpty();
  const BoxTree tree(boxes);
  EXPECT_EQ(tree.size(), 19u);
  const std::vector<index_t> all =
      found(tree, Box(Position::Constant(-9), Position::Constant(9)));
  EXPECT_EQ(std::count(all.begin(), all.end(), 4), 0);
}

TEST(BoxTree, OfNothingFindsNothing)
{
  EXPECT_TRUE(found(BoxTree(), Box(Position(0, 0, 0))).empty());
  EXPECT_TRUE(found(BoxTree({Box(), Box()}), Box(Position(0, 0, 0))).empty());
}

TEST(BoxTree, HoldsBoxesAllInOnePlace)
{
  const BoxTree tree(std::vector<Box>(100, Box(Position(2, 2, 2))));
  EXPECT_EQ(found(tree, Box(Position(2, 2, 2))).size(), 100u);
}

TEST(PackedBoxTree, MissesNoBoxAndNamesNoneThatIsFar)
{
  for (const std::size_t count : {0u, 1u, 7u, 8u, 9u, 64u, 65u, 1000u}) {
    const std::vector<Box> boxes = randomBoxes(count, count);
    const PackedBoxTree tree(count, {2}, [&](std::size_t i) { return boxes[i]; });
    for (const Box& query : randomBoxes(50, 99)) {
      std::vector<index_t> named;
      EXPECT_FALSE(tree.anyMeeting(query, [&](std::size_t i) {
        named.push_back(static_cast<index_t>(i));
        return false;
      }));
      const std::vector<index_t> least = foundOneByOne(boxes, query);
      const std::vector<index_t> most = foundOneByOne(boxes, widened(query, 1e-6));
      EXPECT_TRUE(
          std::includes(named.begin(), named.end(), least.begin(), least.end()));
      EXPECT_TRUE(std::includes(most.begin(), most.end(), named.begin(), named.end()));
    }
  }
}

TEST(PackedBoxTree, StopsAtTheFirstThatPasses)
{
  const std::vector<Box> boxes = randomBoxes(100, 1);
  const PackedBoxTree tree(boxes.size(), {1}, [&](std::size_t i) { return boxes[i]; });
  std::size_t asked = 0;
  EXPECT_TRUE(tree.anyMeeting(Box(Position::Zero(), Position::Ones()),
                              [&](std::size_t) { return ++asked == 3; }));
  EXPECT_EQ(3U, asked);
}

} // namespace
} // namespace test
} // namespace ccaa
} // namespace pcl
