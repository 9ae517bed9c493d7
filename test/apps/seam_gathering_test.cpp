// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what a seam is told of the triangles around it.
#include "out_of_core/seam_gathering.h"
#include "out_of_core/tile_points.h"
#include "out_of_core/tile_steps.h"
#include "tiles_fixture.h"

#include <algorithm>

namespace app_test {
namespace {

using pcl::ccaa::Position;
using pcl::ccaa::WideIndex;
using pcl::ccaa::WideTriangle;

/** One dispute in the middle of the first tile of a square lattice. */
class SeamGathering : public TiledApp {
protected:
  SeamGathering()
  {
    save(folder_.path("in.ply"), test::toRawCloud(test::grid(119, 59).vertices));
    step("cut", "tiles", {folder_.path("in.ply"), "--tiles=4000"});
    plan_ = app::readPlan(folder_.path("tiles"));
  }

  /** The point of the first tile at so many halos from its middle. */
  WideIndex
  at(double x, double y) const
  {
    const pcl::ccaa::Tile& tile = plan_.tiling.tiles[0];
    const Position place = tile.box.center() + tile.halo * Position(x, y, 0.0);
    const app::TilePoints points(plan_, 0);
    WideIndex nearest = 0;
    for (WideIndex i = 0; i < points.size(); ++i)
      if ((points.position(i) - place).norm() <
          (points.position(nearest) - place).norm())
        nearest = i;
    return nearest;
  }

  /** This is all that the tiles agree about, and the place is that of the disputes:
   * one for each group. */
  void
  agree(const WideTriangle& triangle, const std::vector<app::DisputeGroup>& groups)
  {
    const pcl::ccaa::Tile& own = plan_.tiling.tiles[0];
    const app::TilePoints points(plan_, 0);
    for (std::size_t tile = 0; tile < plan_.tiling.tiles.size(); ++tile) {
      app::TileMesh mesh;
      app::JoinedTile joined;
      if (tile == 0) {
        for (WideIndex i = 0; i < points.size(); ++i)
          mesh.border.points.push_back({i, points.position(i)});
        joined.triangles = {triangle};
      }
      app::writeMesh(plan_, tile, mesh);
      app::writeJoined(plan_, tile, joined);
    }
    const Position place = points.position(at(0.0, 0.0));
    app::AllDisputes disputes;
    disputes.groups = groups;
    for (const app::DisputeGroup& group : groups)
      disputes.disputes.push_back({plan_.tiling.tiles[group.tile].first,
                                   {place.x(), place.y(), place.z()},
                                   0.1 * own.halo,
                                   0.4 * own.halo});
    app::writeDisputes(plan_, disputes);
  }

  /** The triangles that a tile is told, in numbers of the whole. */
  std::vector<WideTriangle>
  gathered(std::size_t tile)
  {
    app::SeamGathering gathering(plan_, tile);
    gathering.read();
    std::vector<WideIndex> wide;
    std::vector<WideTriangle> triangles;
    for (const pcl::ccaa::Triangle& given : gathering.gather(0, wide).given)
      triangles.push_back({wide[std::size_t(given[0])],
                           wide[std::size_t(given[1])],
                           wide[std::size_t(given[2])]});
    return triangles;
  }

  /** Whether the part of the first tile may give triangles to a point that is a dispute
   * of another part of its group. */
  bool
  opensDisputeOfAnotherPart(WideIndex point)
  {
    agree({at(-0.1, 0.0), point, at(0.0, 0.3)}, {{0, 0, 0, 1}, {1, 0, 1, 2}});
    app::AllDisputes all = app::readDisputes(plan_);
    const Position place = app::TilePoints(plan_, 0).position(point);
    all.disputes[1].index = point;
    all.disputes[1].position = {place.x(), place.y(), place.z()};
    app::writeDisputes(plan_, all);
    app::SeamGathering gathering(plan_, 0);
    gathering.read();
    std::vector<WideIndex> wide;
    const pcl::ccaa::Seam seam = gathering.gather(0, wide);
    const auto found = std::lower_bound(wide.begin(), wide.end(), point);
    return seam.is_open[std::size_t(found - wide.begin())] != 0;
  }

  std::size_t
  gather(const WideTriangle& triangle)
  {
    agree(triangle, {{0, 0, 0, 1}});
    return gathered(0).size();
  }

  app::TilePlan plan_;
};

TEST_F(SeamGathering, TakesTrianglesWithACornerNearby)
{
  ASSERT_GE(plan_.tiling.tiles.size(), 4U);
  EXPECT_EQ(gather({at(0.3, 0.0), at(0.5, 0.0), at(0.5, 0.1)}), 1U);
}

TEST_F(SeamGathering, TakesTrianglesThatPassWithAllCornersFarther)
{
  EXPECT_EQ(gather({at(-0.5, 0.0), at(0.5, 0.0), at(0.5, 0.1)}), 1U);
}

TEST_F(SeamGathering, LeavesTrianglesFartherAway)
{
  EXPECT_EQ(gather({at(0.5, 0.3), at(0.5, 0.0), at(0.6, 0.1)}), 0U);
}

TEST_F(SeamGathering, ALaterPartSeesWhatEarlierOnesHaveLeftAndMade)
{
  const WideTriangle before{at(0.1, 0.0), at(0.2, 0.0), at(0.2, 0.1)};
  const WideTriangle after{at(0.1, 0.0), at(0.2, 0.1), at(0.1, 0.2)};
  agree(before, {{0, 0, 0, 1}, {1, 0, 1, 2}});
  app::ClosedTile closed;
  closed.removed = {pcl::ccaa::cornersInOrder(before)};
  closed.added = {after};
  app::writeClosed(plan_, 0, closed);
  EXPECT_EQ(gathered(0), std::vector<WideTriangle>{before});
  EXPECT_EQ(gathered(1), std::vector<WideTriangle>{after});
}

TEST_F(SeamGathering, APartOpensDisputesOfAnotherWithWhichItMayShareATriangle)
{
  EXPECT_TRUE(opensDisputeOfAnotherPart(at(0.15, 0.0)));
}

TEST_F(SeamGathering, APartLeavesFartherDisputesToOthers)
{
  EXPECT_FALSE(opensDisputeOfAnotherPart(at(0.3, 0.0)));
}

TEST_F(SeamGathering, PartsOfOtherGroupsAreNoneThatComeBefore)
{
  agree({0, 1, 2}, {{0, 0, 0, 1}, {1, 1, 1, 2}});
  EXPECT_TRUE(app::SeamGathering(plan_, 1).earlier().empty());
}

/** All points of some tiles are disputes. */
app::AllDisputes
groupsOf(const app::TilePlan& plan, std::size_t tiles)
{
  for (std::size_t tile = 0; tile < plan.tiling.tiles.size(); ++tile) {
    const app::TilePoints points(plan, tile);
    app::JoinedTile joined;
    for (std::size_t i = 0; tile < tiles && i < points.size(); ++i) {
      const Position place = points.position(i);
      joined.disputes.push_back({plan.tiling.tiles[tile].first + i,
                                 {place.x(), place.y(), place.z()},
                                 2.0,
                                 4.0});
    }
    app::writeJoined(plan, tile, joined);
  }
  app::groupAllDisputes(plan);
  return app::readDisputes(plan);
}

TEST_F(SeamGathering, ALargeGroupHasAPartForEachTile)
{
  const std::vector<app::DisputeGroup> groups =
      groupsOf(plan_, plan_.tiling.tiles.size()).groups;
  ASSERT_EQ(groups.size(), plan_.tiling.tiles.size());
  for (std::size_t i = 0; i < groups.size(); ++i) {
    EXPECT_EQ(groups[i].tile, i);
    EXPECT_EQ(groups[i].whole, 0U);
    EXPECT_EQ(groups[i].end - groups[i].begin, plan_.tiling.tiles[i].count);
  }
}

TEST_F(SeamGathering, AGroupOfOneTileIsNotCut)
{
  EXPECT_EQ(groupsOf(plan_, 1).groups.size(), 1U);
}

} // namespace
} // namespace app_test
