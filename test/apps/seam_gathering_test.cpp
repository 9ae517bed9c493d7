// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what a seam is told of the triangles around it.
#include "out_of_core/seam_gathering.h"
#include "out_of_core/tile_points.h"
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

  /** What is gathered where this is all that the tiles agree about. */
  pcl::ccaa::Seam
  gather(const WideTriangle& triangle)
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
    disputes.groups = {{0, 0, 1}};
    disputes.disputes = {{at(0.0, 0.0),
                          {place.x(), place.y(), place.z()},
                          0.1 * own.halo,
                          0.4 * own.halo}};
    app::writeDisputes(plan_, disputes);
    app::SeamGathering gathering(plan_, 0);
    gathering.read();
    std::vector<WideIndex> wide;
    return gathering.gather(0, wide);
  }

  app::TilePlan plan_;
};

TEST_F(SeamGathering, TakesTrianglesWithACornerNearby)
{
  ASSERT_GE(plan_.tiling.tiles.size(), 4U);
  EXPECT_EQ(gather({at(0.3, 0.0), at(0.5, 0.0), at(0.5, 0.1)}).given.size(), 1U);
}

TEST_F(SeamGathering, TakesTrianglesThatPassWithAllCornersFarther)
{
  EXPECT_EQ(gather({at(-0.5, 0.0), at(0.5, 0.0), at(0.5, 0.1)}).given.size(), 1U);
}

TEST_F(SeamGathering, LeavesTrianglesFartherAway)
{
  EXPECT_TRUE(gather({at(0.5, 0.3), at(0.5, 0.0), at(0.6, 0.1)}).given.empty());
}

} // namespace
} // namespace app_test
