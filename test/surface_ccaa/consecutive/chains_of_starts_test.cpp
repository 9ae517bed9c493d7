// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of chains with more than one start algorithm
// (D3.1-1).
#include <pcl/surface_ccaa/greedy_start.h>
#include <pcl/surface_ccaa/umbrella_filter.h>

#include "chain_fixture.h"

#include <algorithm>
#include <set>

namespace pcl::ccaa::test {
namespace {

/** A mesh of which the start algorithms make parts. */
class ConsecutiveChainTest : public ConsecutiveTest {
protected:
  ConsecutiveChainTest()
  {
    const auto split = shape_.triangles.begin() + 900;
    first_.assign(shape_.triangles.begin(), split);
    rest_.assign(split, shape_.triangles.end());
    chain_.setStartAlgorithm(startGiving(toPolygons(first_)));
    chain_.setFilter(openFilter());
  }

  Shape shape_ = terrain(25, 25); // 1152 triangles
  Triangles first_;
  Triangles rest_;
};

/** A completion that puts further triangles behind the given ones. */
std::shared_ptr<ScriptedCompletion>
completionAdding(const Triangles& more)
{
  return std::make_shared<ScriptedCompletion>([more](Polygons& polygons, const Cloud&) {
    for (const Vertices& polygon : toPolygons(more))
      polygons.push_back(polygon);
  });
}

TEST_F(ConsecutiveChainTest, TrianglesStandInTheOrderOfTheAlgorithms)
{
  const Triangles second(rest_.begin(), rest_.begin() + 200);
  const Triangles last(rest_.begin() + 200, rest_.end());
  chain_.addStartAlgorithm(completionAdding(second));
  chain_.setBaseAlgorithm(completionAdding(last));
  EXPECT_EQ(reconstruct(shape_.vertices), shape_.triangles);
  const auto& labels = chain_.getTriangleLabels();
  EXPECT_TRUE(std::is_sorted(labels.begin(), labels.end()));
  const auto& stages = chain_.getReport().stages;
  ASSERT_EQ(stages.size(), 3u);
  EXPECT_EQ(stages[1].name, "start 2");
  EXPECT_EQ(stages[0].triangles, 900u);
  EXPECT_EQ(stages[1].triangles, 200u);
  EXPECT_EQ(stages[2].triangles, 52u);
  EXPECT_GT(stages[1].internal_points, stages[0].internal_points);
  EXPECT_EQ(chain_.getReport().internal_points, stages[1].internal_points);
}

TEST_F(ConsecutiveChainTest, AFurtherStartGetsThePointsThatAreNotInternal)
{
  std::size_t offered = 0;
  chain_.addStartAlgorithm(std::make_shared<ScriptedStart>(
      [&offered](const Cloud& cloud, const Indices& indices) {
        offered = indices.size();
        EXPECT_EQ(indices.size(), cloud.size());
        return Polygons();
      }));
  reconstruct(shape_.vertices);
  EXPECT_EQ(offered, 625 - chain_.getReport().internal_points);
  EXPECT_GT(offered, 96u); // the rim of 25 * 25 at least
}

TEST_F(ConsecutiveChainTest, AFurtherStartOfOursGetsIndicesIntoTheCloud)
{
  const auto cloud = toCloud(noisySphere(3000, 0.02));
  const Triangles once = startAndFilter(cloud);
  Chain chain;
  chain.setBaseAlgorithm(nullptr);
  chain.addStartAlgorithm(std::make_shared<GreedyStart<PointXYZ>>());
  chain.setInputCloud(cloud);
  Polygons polygons;
  chain.reconstruct(polygons);
  const auto& stages = chain.getReport().stages;
  EXPECT_TRUE(isIcadm(toTriangles(polygons), 3000));
  EXPECT_EQ(stages[0].triangles + stages[1].triangles, polygons.size());
  EXPECT_GE(chain.getReport().internal_points, stages[0].internal_points);
}

TEST_F(ConsecutiveChainTest, ACompletionAsFurtherStartGetsTheMeshAndAllPoints)
{
  const auto second = completionAdding(rest_);
  chain_.addStartAlgorithm(second);
  EXPECT_TRUE(sameUnorientedTriangles(shape_.triangles, reconstruct(shape_.vertices)));
  EXPECT_EQ(second->given_triangles, 900u);
  EXPECT_EQ(second->given_indices.size(), 625u);
}

TEST_F(ConsecutiveChainTest, TrianglesThatAreThereAlreadyAreNotAddedAgain)
{
  Triangles again(first_.end() - 100, first_.end());
  for (Triangle& t : again)
    t = {t[2], t[0], t[1]};
  again = reversed(again);
  again.insert(again.end(), rest_.begin(), rest_.end());
  again.insert(again.end(), rest_.begin(), rest_.end());
  chain_.addStartAlgorithm(completionAdding(again));
  EXPECT_EQ(reconstruct(shape_.vertices), shape_.triangles);
}

TEST_F(ConsecutiveChainTest, AStageThatMakesInternalPointsFewerIsDropped)
{
  const Triangles harm = {{0, 1, 600}, {0, 1, 601}, {200, 201, 300}, {100, 150, 400}};
  chain_.setFilter(std::make_shared<UmbrellaFilter>());
  const Triangles expected = reconstruct(shape_.vertices);
  chain_.setFilter(std::make_shared<ScriptedFilter>([&](PolygonMesh& mesh) {
    if (mesh.polygons.size() > first_.size())
      mesh.polygons.resize(300);
  }));
  chain_.addStartAlgorithm(completionAdding(harm));
  EXPECT_TRUE(sameUnorientedTriangles(expected, reconstruct(shape_.vertices)));
  EXPECT_FALSE(chain_.getReport().stages[1].kept);
  EXPECT_LT(chain_.getReport().stages[1].internal_points,
            chain_.getReport().internal_points);
  EXPECT_EQ(chain_.getReport().stages[1].triangles, 0u);
}

TEST_F(ConsecutiveChainTest, LabelsFollowAFilterThatShufflesAndTurns)
{
  chain_.addStartAlgorithm(completionAdding(rest_));
  chain_.setFilter(std::make_shared<ScriptedFilter>([](PolygonMesh& mesh) {
    std::reverse(mesh.polygons.begin(), mesh.polygons.end());
    for (Vertices& polygon : mesh.polygons)
      std::swap(polygon.vertices[0], polygon.vertices[1]);
  }));
  const Triangles triangles = reconstruct(shape_.vertices);
  EXPECT_TRUE(sameUnorientedTriangles(shape_.triangles, triangles));
  Triangles of_first;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    if (chain_.getTriangleLabels()[i] == 0)
      of_first.push_back(triangles[i]);
  EXPECT_TRUE(sameUnorientedTriangles(first_, of_first));
}

TEST_F(ConsecutiveChainTest, NothingIsLeftToAFurtherStartOnAClosedSurface)
{
  const Shape sphere = icosphere(3);
  const auto second = startGiving({});
  chain_.setStartAlgorithm(startGiving(toPolygons(sphere.triangles)));
  chain_.addStartAlgorithm(second);
  EXPECT_EQ(reconstruct(sphere.vertices), sphere.triangles);
  EXPECT_EQ(second->runs, 0);
}

/** Gives back every third triangle, and those that a chain has not got yet. */
std::shared_ptr<ScriptedCompletion>
replacingCompletion(const Triangles& more)
{
  const auto completion = std::make_shared<ScriptedCompletion>();
  auto* const kept = &completion->kept;
  completion->may_replace = true;
  completion->setScript([kept, more](Polygons& polygons, const Cloud&) {
    kept->clear();
    Polygons left;
    for (std::size_t i = 0; i < polygons.size(); i += 3) {
      kept->push_back(static_cast<index_t>(i));
      left.push_back(polygons[i]);
    }
    for (const Vertices& polygon : toPolygons(more))
      left.push_back(polygon);
    polygons = left;
  });
  return completion;
}

TEST_F(ConsecutiveChainTest, ABaseMayReplaceTrianglesWhenItTellsSo)
{
  chain_.setBaseAlgorithm(replacingCompletion(rest_));
  const Triangles triangles = reconstruct(shape_.vertices);
  const auto& labels = chain_.getTriangleLabels();
  ASSERT_EQ(triangles.size(), 300u + rest_.size());
  EXPECT_EQ(triangles[1], first_[3]);
  EXPECT_EQ(std::count(labels.begin(), labels.end(), 0), 300);
  EXPECT_EQ(chain_.getReport().stages[1].triangles, rest_.size());
  std::set<index_t> used;
  for (const Triangle& t : triangles)
    used.insert(t.begin(), t.end());
  EXPECT_EQ(chain_.getReport().free_points, 625 - used.size());
}

TEST_F(ConsecutiveChainTest, AFurtherStartMayReplaceTrianglesToo)
{
  chain_.setFilter(std::make_shared<ScriptedFilter>([](PolygonMesh&) {}));
  Triangles more = first_;
  more.insert(more.end(), rest_.begin(), rest_.end());
  chain_.addStartAlgorithm(replacingCompletion(more));
  EXPECT_TRUE(sameUnorientedTriangles(shape_.triangles, reconstruct(shape_.vertices)));
  EXPECT_EQ(chain_.getReport().stages[0].triangles, 300u);
  EXPECT_EQ(chain_.getReport().stages[1].triangles, 852u);
}

TEST_F(ConsecutiveChainTest, NumbersOfKeptTrianglesMustBeTrue)
{
  const auto base = std::make_shared<ScriptedCompletion>();
  base->may_replace = true;
  chain_.setBaseAlgorithm(base);
  for (const std::vector<index_t>& wrong :
       std::vector<std::vector<index_t>>{{1}, {0, 2}, {0, 0}, {-1}, {5000}}) {
    base->kept = wrong;
    EXPECT_TRUE(reconstruct(shape_.vertices).empty());
  }
}

TEST_F(ConsecutiveChainTest, AFurtherStartThatLosesGivenTrianglesIsAnError)
{
  chain_.addStartAlgorithm(std::make_shared<ScriptedCompletion>(
      [](Polygons& polygons, const Cloud&) { polygons.erase(polygons.begin()); }));
  EXPECT_TRUE(reconstruct(shape_.vertices).empty());
}

} // namespace
} // namespace pcl::ccaa::test
