// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of the rows of table T3.4-1.
#include "filter_helpers.h"
#include "umbrella/chain_case.h"

#include <cmath>

namespace pcl::ccaa::test {
namespace {

/** \brief Builds surfaces around vertex 0 at the origin. */
struct Surroundings {
  Shape shape{{Position::Zero()}, {}};

  /** \brief Add a chain of triangles whose far corners lie on an arc of the unit circle
   * in the plane at height z. */
  Surroundings&
  chain(int size, bool closed, double z, double from = 0.0, double step = 0.5)
  {
    const auto first = static_cast<pcl::index_t>(shape.vertices.size());
    const int corners = closed ? size : size + 1;
    if (closed)
      step = 2.0 * M_PI / size;
    for (int i = 0; i < corners; ++i)
      shape.vertices.emplace_back(
          std::cos(from + i * step), std::sin(from + i * step), z);
    for (int i = 0; i < size; ++i)
      shape.triangles.push_back({0, first + i, first + (i + 1) % corners});
    return *this;
  }
};

struct Judgement {
  ChainCase row = ChainCase::NO_CHAIN;
  bool any_survives = false;
  std::vector<pcl::index_t>
      survivor; /**< triangles of the chain that stays, ascending */
};

Judgement
judge(const Shape& shape)
{
  TriangleAdjacency adjacency;
  adjacency.build(shape.triangles, shape.vertices.size());
  PointChains chains;
  chains.find(shape.triangles, adjacency, 0);
  Judgement judgement;
  judgement.row = classifyChains(chains);
  const auto place = survivingChain(chains, shape.triangles, shape.vertices, 0);
  judgement.any_survives = place.has_value();
  if (place) {
    const FanChain& chain = chains.chains()[*place];
    for (std::size_t i = 0; i < chain.size; ++i)
      judgement.survivor.push_back(chains.triangles()[chain.first + i]);
  }
  std::sort(judgement.survivor.begin(), judgement.survivor.end());
  return judgement;
}

TEST(ChainCase, PointWithoutTrianglesIsInNoRow)
{
  const auto result = judge(Surroundings().shape);
  EXPECT_EQ(result.row, ChainCase::NO_CHAIN);
  EXPECT_FALSE(result.any_survives);
}

TEST(ChainCase, Row1KeepsTheOnlyClosedChain)
{
  const auto result = judge(Surroundings().chain(5, true, 0.0).shape);
  EXPECT_EQ(result.row, ChainCase::ONE_CLOSED);
  EXPECT_EQ(result.survivor.size(), 5u);
}

TEST(ChainCase, Row2KeepsTheOnlyOpenChain)
{
  const auto result = judge(Surroundings().chain(4, false, 0.0).shape);
  EXPECT_EQ(result.row, ChainCase::ONE_OPEN);
  EXPECT_EQ(result.survivor.size(), 4u);
}

TEST(ChainCase, Row3KeepsTheLongestOfSeveralOpenChains)
{
  const auto result = judge(Surroundings()
                                .chain(2, false, 0.0)
                                .chain(3, false, 0.5)
                                .chain(1, false, -0.5)
                                .shape);
  EXPECT_EQ(result.row, ChainCase::SEVERAL_OPEN);
  EXPECT_EQ(result.survivor, (std::vector<pcl::index_t>{2, 3, 4}));
}

TEST(ChainCase, Row3BreaksTiesByTheLargerSumOfAngles)
{
  const auto result =
      judge(Surroundings().chain(2, false, 0.0, 0.0, 0.3).chain(2, false, 0.5).shape);
  EXPECT_EQ(result.row, ChainCase::SEVERAL_OPEN);
  EXPECT_EQ(result.survivor, (std::vector<pcl::index_t>{2, 3}));
}

TEST(ChainCase, Row3BreaksEqualAnglesByTheLowestCorner)
{
  for (const bool swapped : {false, true}) {
    const double low = swapped ? 0.5 : -0.5;
    const auto result =
        judge(Surroundings().chain(2, false, low).chain(2, false, -low).shape);
    EXPECT_EQ(result.survivor,
              swapped ? (std::vector<pcl::index_t>{2, 3})
                      : (std::vector<pcl::index_t>{0, 1}));
  }
}

TEST(ChainCase, Row3BreaksCompleteTiesByTheLowestTriangle)
{
  const auto result =
      judge(Surroundings().chain(2, false, 0.5).chain(2, false, 0.5).shape);
  EXPECT_EQ(result.survivor, (std::vector<pcl::index_t>{0, 1}));
}

TEST(ChainCase, Row4KeepsTheClosedChainEvenIfAnOpenOneIsLonger)
{
  const auto result = judge(Surroundings()
                                .chain(5, false, 0.5)
                                .chain(3, true, 0.0)
                                .chain(1, false, 2.0)
                                .shape);
  EXPECT_EQ(result.row, ChainCase::CLOSED_AND_OPEN);
  EXPECT_EQ(result.survivor, (std::vector<pcl::index_t>{5, 6, 7}));
}

TEST(ChainCase, Row5KeepsNothing)
{
  const auto two = judge(Surroundings().chain(5, true, 0.0).chain(3, true, 0.5).shape);
  EXPECT_EQ(two.row, ChainCase::SEVERAL_CLOSED);
  EXPECT_FALSE(two.any_survives);
  const auto more = judge(Surroundings()
                              .chain(5, true, 0.0)
                              .chain(3, true, 0.5)
                              .chain(9, false, 1.0)
                              .shape);
  EXPECT_EQ(more.row, ChainCase::SEVERAL_CLOSED);
  EXPECT_FALSE(more.any_survives);
}

// The same rows through the whole filter.

TEST(UmbrellaFilter, Row1MakesAnInternalPoint)
{
  const auto shape = Surroundings().chain(5, true, 0.0).shape;
  const auto result = filtered(shape);
  expectCertified(shape, result);
  EXPECT_EQ(result.triangles.size(), 5u);
  EXPECT_EQ(result.roles[0], PointRole::INTERNAL);
}

TEST(UmbrellaFilter, Row2MakesABoundaryPointOfALargeRegion)
{
  const auto shape = grid(6, 6);
  const auto result = filtered(shape, 10);
  expectCertified(shape, result);
  EXPECT_EQ(result.triangles.size(), shape.triangles.size());
  EXPECT_EQ(result.roles[0], PointRole::BOUNDARY);
}

TEST(UmbrellaFilter, Row2MakesAFreePointOfASmallRegion)
{
  const auto shape = Surroundings().chain(4, false, 0.0).shape;
  const auto result = filtered(shape, 1);
  expectCertified(shape, result);
  EXPECT_TRUE(result.triangles.empty());
  EXPECT_EQ(result.roles[0], PointRole::FREE);
}

TEST(UmbrellaFilter, Row3KeepsLongestOfSeveralOpenChains)
{
  const auto shape = Surroundings().chain(2, false, 0.0).chain(3, false, 0.5).shape;
  const auto result = filtered(shape);
  expectCertified(shape, result);
  EXPECT_EQ(result.triangles.size(), 3u);
  EXPECT_EQ(result.roles[0], PointRole::BOUNDARY);
  EXPECT_EQ(result.report.umbrella_triangles, 2u);
}

TEST(UmbrellaFilter, Row4DeletesOpenChainsBesideAClosedOne)
{
  const auto shape = Surroundings()
                         .chain(6, true, 0.0)
                         .chain(3, false, 0.5)
                         .chain(1, false, 2.0)
                         .shape;
  const auto result = filtered(shape);
  expectCertified(shape, result);
  EXPECT_EQ(result.triangles.size(), 6u);
  EXPECT_EQ(result.roles[0], PointRole::INTERNAL);
  EXPECT_EQ(result.report.umbrella_triangles, 4u);
}

TEST(UmbrellaFilter, Row5MakesAFreePointOfSeveralClosedChains)
{
  const auto shape = Surroundings().chain(6, true, 0.0).chain(4, true, 0.5).shape;
  const auto result = filtered(shape);
  expectCertified(shape, result);
  EXPECT_TRUE(result.triangles.empty());
  EXPECT_EQ(result.roles[0], PointRole::FREE);
  EXPECT_EQ(result.report.umbrella_triangles, 10u);
}

} // namespace
} // namespace pcl::ccaa::test
