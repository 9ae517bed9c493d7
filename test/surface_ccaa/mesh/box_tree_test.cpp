// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of mesh/box_tree.h.
#include <gtest/gtest.h>

#include "mesh/box_tree.h"
#include "support/random_source.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace pcl::ccaa::test {
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

/** What a tree names is all that meets the query, and nothing that is far from it. */
void
expectMeeting(const std::vector<index_t>& named,
              const std::vector<Box>& boxes,
              const Box& query)
{
  const std::vector<index_t> least = foundOneByOne(boxes, query);
  const std::vector<index_t> most = foundOneByOne(boxes, widened(query, 1e-5));
  EXPECT_TRUE(std::includes(named.begin(), named.end(), least.begin(), least.end()));
  EXPECT_TRUE(std::includes(most.begin(), most.end(), named.begin(), named.end()));
}

/** Squared distance of the segment from a to b from a box, by bisection: convex. */
double
squaredDistance(const Box& box, const Position& a, const Position& b)
{
  double low = 0.0, high = 1.0;
  const auto at = [&](double t) {
    return box.squaredExteriorDistance(Position(a + t * (b - a)));
  };
  for (int i = 0; i < 100; ++i) {
    const double third = (high - low) / 3.0;
    if (at(low + third) < at(high - third))
      high -= third;
    else
      low += third;
  }
  return at(0.5 * (low + high));
}

/** Far longer than the boxes are apart, through the middle of each. */
TEST(BoxTree, MissesNothingThatAVeryLongSegmentPasses)
{
  const std::vector<Box> boxes = randomBoxes(500, 3);
  const BoxTree tree(boxes);
  RandomSource random(4);
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    const Eigen::Vector3d way(
        random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5);
    const Position middle = boxes[k].center();
    const bool is_found =
        tree.anyAlong(middle - 1e5 * way, middle + 2e5 * way, [&](index_t index) {
          return static_cast<std::size_t>(index) == k;
        });
    EXPECT_TRUE(is_found) << k;
  }
}

/** Boxes that meet a triangle's box and reach between its corners along its normal. */
std::vector<index_t>
meetingPlane(const std::vector<Box>& boxes, const Corners& triangle, double room)
{
  const Eigen::Vector3d normal = unitNormal(triangle);
  const auto place = [&](const Position& p) { return normal.dot(p - triangle[0]); };
  std::vector<index_t> result;
  for (const index_t i : foundOneByOne(boxes, widened(boxOf(triangle), room))) {
    const Box& box = boxes[static_cast<std::size_t>(i)];
    double low = place(box.min()), high = low;
    for (int corner = 1; corner < 8; ++corner) {
      const double at = place(box.corner(static_cast<Box::CornerType>(corner)));
      low = std::min(low, at);
      high = std::max(high, at);
    }
    if (low <= room && high >= -room)
      result.push_back(i);
  }
  return result;
}

/** \param[in] flatness of triangles: the third corner to the line of the others */
void
expectFindsAtPlane(double flatness, const Position& shift)
{
  RandomSource random(5);
  std::vector<Box> boxes = randomBoxes(1000, 7);
  for (Box& box : boxes)
    box.translate(shift);
  const BoxTree tree(boxes);
  const auto anywhere = [&] {
    return Position(random.uniform(), random.uniform(), random.uniform());
  };
  for (int i = 0; i < 100; ++i) {
    const Position a = shift + anywhere(), b = shift + anywhere();
    const Corners triangle{a, b, Position(a + 0.4 * (b - a) + flatness * anywhere())};
    std::vector<index_t> named;
    tree.forEachMeeting(triangle, [&](index_t index) { named.push_back(index); });
    std::sort(named.begin(), named.end());
    const auto least = meetingPlane(boxes, triangle, 0.0);
    const auto most = meetingPlane(boxes, triangle, 1e-5);
    EXPECT_TRUE(std::includes(named.begin(), named.end(), least.begin(), least.end()));
    EXPECT_TRUE(std::includes(most.begin(), most.end(), named.begin(), named.end()));
  }
}

TEST(BoxTree, FindsWhatMeetsTheBoxAndThePlaneOfATriangle)
{
  expectFindsAtPlane(1.0, Position::Zero());
}

TEST(BoxTree, FindsTheSameAtTheCoordinatesOfAMap)
{
  expectFindsAtPlane(1.0, Position(596600.0, 5420300.0, 120.0));
}

/** Their normals are hardly known. */
TEST(BoxTree, MissesNothingThatANeedlePasses)
{
  const std::vector<Box> boxes = randomBoxes(1000, 7);
  const BoxTree tree(boxes);
  RandomSource random(9);
  const auto anywhere = [&] {
    return Position(random.uniform(), random.uniform(), random.uniform());
  };
  for (const double flatness : {1e-6, 1e-15, 0.0})
    for (int i = 0; i < 100; ++i) {
      const Position a = anywhere(), b = anywhere();
      const Corners needle{a, b, Position(a + 0.4 * (b - a) + flatness * anywhere())};
      std::set<index_t> named;
      tree.forEachMeeting(needle, [&](index_t index) { named.insert(index); });
      for (std::size_t k = 0; k < boxes.size(); ++k) {
        const bool is_passed = squaredDistance(boxes[k], a, b) == 0.0;
        EXPECT_TRUE(!is_passed || named.count(static_cast<index_t>(k)) > 0) << flatness;
      }
    }
}

TEST(BoxTree, FindsWhatLookingAtEveryBoxFinds)
{
  for (const std::size_t count : {1u, 7u, 8u, 9u, 64u, 65u, 1000u}) {
    const std::vector<Box> boxes = randomBoxes(count, count);
    const BoxTree sorted(boxes);
    const BoxTree in_order(count, {2}, [&](std::size_t i) { return boxes[i]; });
    for (const Box& query : randomBoxes(50, 99)) {
      expectMeeting(found(sorted, query), boxes, query);
      expectMeeting(found(in_order, query), boxes, query);
    }
  }
}

TEST(BoxTree, FindsBoxesFarFromTheOriginAndOfAnySize)
{
  for (const double scale : {1e-30, 1e-3, 1e3, 1e30}) {
    const std::vector<Box> unit = randomBoxes(200, 7);
    const auto placed = [&](const Box& box) {
      const Position offset = Position(9.0, -7.0, 5.0);
      return Box(scale * (box.min() + offset), scale * (box.max() + offset));
    };
    std::vector<Box> boxes;
    for (const Box& box : unit)
      boxes.push_back(placed(box));
    const BoxTree tree(boxes);
    for (const Box& query : randomBoxes(20, 99)) {
      expectMeeting(found(tree, placed(query)), unit, query);
      EXPECT_TRUE(found(tree, Box(1e6 * placed(query).min())).empty());
    }
  }
}

TEST(BoxTree, FindsTheBoxesThatASegmentPasses)
{
  const std::vector<Box> boxes = randomBoxes(300, 5);
  const BoxTree tree(boxes);
  for (const Box& way : randomBoxes(100, 98)) {
    const Position a = way.min(), b = Position::Ones() - way.max();
    std::set<index_t> named;
    EXPECT_FALSE(
        tree.anyAlong(a, b, [&](index_t i) { return !named.insert(i).second; }));
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const double distance = std::sqrt(squaredDistance(boxes[i], a, b));
      EXPECT_LE(named.count(static_cast<index_t>(i)), distance < 1e-5 ? 1U : 0U);
      EXPECT_GE(named.count(static_cast<index_t>(i)), distance > 0.0 ? 0U : 1U);
    }
  }
}

TEST(BoxTree, IsTheSameForAnyNumberOfThreads)
{
  const std::vector<Box> boxes = randomBoxes(5000, 1);
  for (const int threads : {2, 3, 8})
    EXPECT_EQ(BoxTree(boxes).order(), BoxTree(boxes, threads).order());
}

TEST(BoxTree, HasAllBoxesAfterCancelling)
{
  const std::vector<Box> boxes = randomBoxes(5000, 1);
  RunControl whole;
  const BoxTree unhurried(boxes, 1, &whole);
  EXPECT_GE(whole.work(), 10 * boxes.size());
  for (const int threads : {1, 3})
    for (const std::uint64_t part : {100, 10, 2}) {
      RunControl control(nullptr, whole.work() / part);
      const BoxTree tree(boxes, threads, &control);
      EXPECT_TRUE(control.cancelled());
      for (const Box& query : randomBoxes(20, part))
        EXPECT_EQ(found(unhurried, query), found(tree, query));
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
    std::vector<index_t> least, most;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const double squared = boxes[i].squaredExteriorDistance(query);
      if (squared <= 0.04)
        least.push_back(static_cast<index_t>(i));
      if (squared <= 0.04 + 1e-5)
        most.push_back(static_cast<index_t>(i));
    }
    EXPECT_TRUE(std::includes(near.begin(), near.end(), least.begin(), least.end()));
    EXPECT_TRUE(std::includes(most.begin(), most.end(), near.begin(), near.end()));
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
  EXPECT_EQ(tree.order().size(), 19u);
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

TEST(BoxTree, StopsAtTheFirstThatPasses)
{
  const std::vector<Box> boxes = randomBoxes(100, 1);
  const BoxTree tree(boxes);
  std::size_t asked = 0;
  EXPECT_TRUE(tree.anyMeeting(Box(Position::Zero(), Position::Ones()),
                              [&](index_t) { return ++asked == 3; }));
  EXPECT_EQ(3U, asked);
}

} // namespace
} // namespace pcl::ccaa::test
