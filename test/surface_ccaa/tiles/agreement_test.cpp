// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what tiles make alike stays, against a slow twin that knows
// all tiles.
#include <gtest/gtest.h>

#include "patchwork.h"
#include "support/edge_sets.h"
#include "support/mesh_asserts.h"
#include "support/random_source.h"
#include "tiles/agreement.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <vector>

namespace pcl::ccaa::test {
namespace {

/** Everything is looked at, and every tile. */
class Twin {
public:
  explicit Twin(const Patchwork& patchwork) : all_(patchwork)
  {
    for (const auto& mesh : patchwork.meshes) {
      sets_.emplace_back();
      for (const WideTriangle& triangle : mesh)
        sets_.back().insert(cornersInOrder(triangle));
    }
  }

  bool
  stays(const WideTriangle& triangle) const
  {
    const auto seesAny = [&](std::size_t tile) {
      return std::any_of(triangle.begin(), triangle.end(), [&](WideIndex i) {
        return all_.sees(tile, i);
      });
    };
    const std::size_t own = all_.tiling.ownerOf(triangle[0]);
    bool is_shared = false;
    for (std::size_t tile = 0; tile < sets_.size(); ++tile) {
      is_shared = is_shared || (tile != own && seesAny(tile));
      if ((tile == own || seesAll(tile, triangle)) && !has(tile, triangle))
        return false;
    }
    return !is_shared ||
           std::all_of(triangle.begin(), triangle.end(), [&](WideIndex i) {
             const std::size_t owner = all_.tiling.ownerOf(i);
             const double halo = std::max(all_.tiling.tiles[owner].halo, all_.halos[i]);
             return seesAll(owner, triangle) && longest(triangle) <= 0.2 * halo;
           });
  }

  /** All triangles of which a tile has the lowest corner, of any mesh. */
  std::set<WideTriangle>
  candidates(std::size_t tile) const
  {
    std::set<WideTriangle> found;
    for (const auto& set : sets_)
      for (const WideTriangle& triangle : set)
        if (all_.tiling.ownerOf(triangle[0]) == tile)
          found.insert(triangle);
    return found;
  }

private:
  bool
  has(std::size_t tile, const WideTriangle& triangle) const
  {
    return sets_[tile].count(triangle) > 0;
  }
  bool
  seesAll(std::size_t tile, const WideTriangle& triangle) const
  {
    return std::all_of(triangle.begin(), triangle.end(), [&](WideIndex i) {
      return all_.sees(tile, i);
    });
  }
  double
  longest(const WideTriangle& t) const
  {
    double length = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
      length =
          std::max(length, (all_.points[t[i]] - all_.points[t[(i + 1) % 3]]).norm());
    return length;
  }

  const Patchwork& all_;
  std::vector<std::set<WideTriangle>> sets_;
};

/** Inner triangles of a tile stay without being asked. */
std::vector<WideTriangle>
keptOf(const Patchwork& patchwork, std::size_t tile, Agreed& agreed)
{
  const BorderMesh border = patchwork.borderOf(tile);
  agreed = agree(patchwork.tiling, tile, border, patchwork.told(tile));
  std::vector<WideTriangle> kept = agreed.triangles;
  const std::set<WideTriangle> asked(border.triangles.begin(), border.triangles.end());
  for (const WideTriangle& triangle : patchwork.meshes[tile])
    if (asked.count(triangle) == 0)
      kept.push_back(triangle);
  return kept;
}

void
expectWhatTheTwinKeeps(double sparse)
{
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Patchwork patchwork(seed, 0.02 * double(seed - 1), 9.0, sparse);
    const Twin twin(patchwork);
    for (std::size_t tile = 0; tile < patchwork.tiling.tiles.size(); ++tile) {
      Agreed agreed;
      std::set<WideTriangle> kept, expected;
      for (const WideTriangle& triangle : keptOf(patchwork, tile, agreed))
        EXPECT_TRUE(kept.insert(cornersInOrder(triangle)).second);
      std::set<WideTriangle> refused;
      for (const WideTriangle& triangle : twin.candidates(tile))
        if (twin.stays(triangle))
          expected.insert(triangle);
        else
          refused.insert(cornersInOrder(triangle));
      EXPECT_TRUE(kept == expected) << seed << ", tile " << tile;
      EXPECT_EQ(std::vector<WideTriangle>(refused.begin(), refused.end()),
                agreed.refused);
    }
  }
}

TEST(Agreement, KeepsWhatTheTwinKeepsAndTellsTheRest) { expectWhatTheTwinKeeps(0.0); }

TEST(Agreement, KeepsWhatTheTwinKeepsAmongSparsePoints) { expectWhatTheTwinKeeps(0.3); }

TEST(Agreement, TrianglesTooLongForTheirTilesStayWhereAllCornersAreSparse)
{
  const Patchwork dense(30, 0.0, 2.0), sparse(30, 0.0, 2.0, 1.0);
  std::size_t of_dense = 0, of_sparse = 0;
  for (std::size_t tile = 0; tile < dense.tiling.tiles.size(); ++tile) {
    Agreed agreed;
    of_dense += keptOf(dense, tile, agreed).size();
    of_sparse += keptOf(sparse, tile, agreed).size();
  }
  EXPECT_LT(of_dense, of_sparse);
}

TEST(Agreement, WhatStaysHasNoEdgeWithThreeTriangles)
{
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Patchwork patchwork(seed + 10, 0.05);
    std::map<std::pair<WideIndex, WideIndex>, int> uses;
    for (std::size_t tile = 0; tile < patchwork.tiling.tiles.size(); ++tile) {
      Agreed agreed;
      for (const WideTriangle& t : keptOf(patchwork, tile, agreed))
        for (std::size_t i = 0; i < 3; ++i)
          EXPECT_LE(++uses[std::minmax(t[i], t[(i + 1) % 3])], 2);
    }
    EXPECT_GT(uses.size(), 3000U);
  }
}

TEST(Agreement, TilesThatMakeTheSameKeepEverything)
{
  const Patchwork patchwork(30, 0.0, 14.0);
  std::size_t kept = 0;
  for (std::size_t tile = 0; tile < patchwork.tiling.tiles.size(); ++tile) {
    Agreed agreed;
    kept += keptOf(patchwork, tile, agreed).size();
    EXPECT_TRUE(agreed.refused.empty());
  }
  EXPECT_EQ(kept, 2U * 47 * 47);
}

TEST(Agreement, ATileThatIsAloneKeepsAll)
{
  Tiling tiling;
  tiling.tiles.emplace_back();
  tiling.tiles.back().count = 4;
  BorderMesh own;
  for (WideIndex i = 0; i < 4; ++i)
    own.points.push_back({i, Position(double(i), 0.0, 0.0)});
  own.triangles = {{0, 1, 2}, {3, 2, 1}};
  const Agreed agreed = agree(tiling, 0, own, {});
  EXPECT_EQ(agreed.triangles, own.triangles);
  EXPECT_TRUE(agreed.refused.empty());
}

/** \param[in] spread of the places: more of it, more groups */
std::vector<Dispute>
randomDisputes(std::uint64_t seed, std::size_t count, double spread)
{
  RandomSource random(seed);
  std::vector<Dispute> disputes(count);
  for (std::size_t i = 0; i < count; ++i) {
    disputes[i].index = 3 * i;
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      disputes[i].position[axis] = float(random.uniform(0.0, spread));
    disputes[i].room = float(random.uniform(0.2, 0.8));
  }
  return disputes;
}

TEST(DisputeGroups, AreThoseWithChainsOfShortSteps)
{
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const auto disputes = randomDisputes(seed, 150, 2.0 + double(seed));
    Sets sets(disputes.size());
    for (std::size_t i = 0; i < disputes.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if ((disputes[i].position - disputes[j].position).norm() <
            2.0F * std::max(disputes[i].room, disputes[j].room))
          sets.join(i, j);
    const auto groups = groupDisputes(disputes);
    std::vector<std::size_t> expected;
    std::map<std::size_t, std::size_t> number_of;
    for (std::size_t i = 0; i < disputes.size(); ++i)
      expected.push_back(
          number_of.emplace(sets.find(i), number_of.size()).first->second);
    EXPECT_EQ(groups, expected) << seed;
  }
  EXPECT_TRUE(groupDisputes({}).empty());
}

} // namespace
} // namespace pcl::ccaa::test
