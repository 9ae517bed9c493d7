// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of the empty-circle test.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "greedy/edge_certificate.h"
#include "ranked_cloud.h"

#include <cmath>
#include <random>

namespace pcl::ccaa::test {
namespace {

constexpr float ANY_LENGTH = 1e6f;

std::vector<EdgeVotes>
votesOf(const RankedCloud& cloud, float reach = ANY_LENGTH)
{
  std::vector<EdgeVotes> votes(cloud.points().size());
  certifyEdges(cloud.points(), cloud.rows(), reach, 0, votes.size(), votes.data());
  return votes;
}

bool
hasBit(std::uint64_t bits, unsigned int slot)
{
  return bits >> slot & 1u;
}

/** Whether point a certifies its edge to b; b must be in the row of a. */
bool
certifies(const RankedCloud& cloud, index_t a, index_t b)
{
  const std::vector<EdgeVotes> votes = votesOf(cloud);
  const NeighborRows rows = cloud.rows();
  for (unsigned int slot = 0; slot < rows.count(a); ++slot)
    if (rows.row(a)[slot] == b)
      return hasBit(votes[std::size_t(a)].certified, slot);
  ADD_FAILURE() << b << " is no neighbor of " << a;
  return false;
}

Positions
randomPlane(std::size_t count, unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(0, 1);
  Positions points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back({place(random), place(random), 0});
  return points;
}

/** Brute force: the edge is Delaunay if some circle through its ends is empty. Only the
 * circles through a third point need to be tried, besides those of the hull. */
bool
isDelaunay(const Positions& points, std::size_t a, std::size_t b)
{
  double widest_left = 0, widest_right = 0;
  for (std::size_t c = 0; c < points.size(); ++c) {
    if (c == a || c == b)
      continue;
    const Position u = points[a] - points[c], v = points[b] - points[c];
    const double angle = std::atan2(u.cross(v).norm(), u.dot(v));
    double& widest = u.cross(v).z() > 0 ? widest_left : widest_right;
    widest = std::max(widest, angle);
  }
  return widest_left + widest_right <= M_PI;
}

TEST(EdgeCertificate, EqualsDelaunayOfRandomPointsInAPlane)
{
  for (unsigned int seed = 0; seed < 5; ++seed) {
    const Positions points = randomPlane(41, seed);
    const RankedCloud cloud(points, 40); // everybody is a witness
    const std::vector<EdgeVotes> votes = votesOf(cloud);
    for (std::size_t a = 0; a < points.size(); ++a)
      for (unsigned int slot = 0; slot < 40; ++slot) {
        const auto b = std::size_t(cloud.rows().row(index_t(a))[slot]);
        EXPECT_EQ(hasBit(votes[a].certified, slot), isDelaunay(points, a, b))
            << "seed " << seed << ", edge " << a << " " << b;
      }
  }
}

TEST(EdgeCertificate, RefusesAnEdgeWithAPointExactlyInItsMiddle)
{
  const RankedCloud cloud(
      {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}}, 5);
  EXPECT_FALSE(certifies(cloud, 0, 2));
  EXPECT_TRUE(certifies(cloud, 0, 1));
}

TEST(EdgeCertificate, TakesTheShortDiagonalOfARhombusOnly)
{
  const RankedCloud cloud({{-2, 0, 0}, {2, 0, 0}, {0, -1, 0}, {0, 1, 0}}, 3);
  EXPECT_TRUE(certifies(cloud, 2, 3));
  EXPECT_FALSE(certifies(cloud, 0, 1));
}

TEST(EdgeCertificate, AFarSheetIsNoWitness)
{
  // The point above the middle of the edge lies on another sheet, 0.8 away.
  const RankedCloud cloud({{0, 0, 0},
                           {1, 0, 0},
                           {0.5, 0.9, 0},
                           {0.5, -0.9, 0},
                           {1.5, 0.9, 0},
                           {-0.5, -0.9, 0},
                           {-0.5, 0.9, 0},
                           {0.5, 0, 0.8}},
                          7);
  EXPECT_TRUE(certifies(cloud, 0, 1));
}

TEST(EdgeCertificate, NoiseAcrossTheSurfaceIsLaidIntoThePlane)
{
  // Zigzag of height 0.5 around the edge: in space the middle point stands aside, in
  // the plane it lies between the ends.
  Positions points = {{0, 0, 0}, {1, 0, 0.1}, {0.5, 0, 0.45}};
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-1.2, 2.2), height(-0.5, 0.5);
  while (points.size() < 17)
    points.push_back({place(random), place(random) - 0.5, height(random)});
  EXPECT_FALSE(certifies(RankedCloud(points, 16), 0, 1));
}

TEST(EdgeCertificate, ReachFollowsTheLocalSpacing)
{
  Positions points;
  for (int i = 0; i < 8; ++i)
    points.push_back({std::cos(i * M_PI / 4), std::sin(i * M_PI / 4), 0});
  points.push_back({0, 0, 0});
  points.push_back({2.9, 0, 0});
  points.push_back({0, 3.1, 0});
  const RankedCloud cloud(points, 10);
  const EdgeVotes votes = votesOf(cloud, 3.0f)[8];
  EXPECT_TRUE(hasBit(votes.in_reach, 8));  // the ninth neighbor, 2.9 spacings away
  EXPECT_FALSE(hasBit(votes.in_reach, 9)); // the tenth, 3.1 away
}

TEST(EdgeCertificate, DoesNotDependOnTheScale)
{
  const Positions points = randomPlane(60, 9);
  const std::vector<EdgeVotes> expected = votesOf(RankedCloud(points, 16));
  // Powers of two keep every digit, so that not even rounding may differ.
  for (const double scale : {std::ldexp(1.0, -60), std::ldexp(1.0, 60)}) {
    Positions scaled = points;
    for (Position& p : scaled)
      p *= scale;
    const std::vector<EdgeVotes> votes = votesOf(RankedCloud(scaled, 16));
    for (std::size_t i = 0; i < votes.size(); ++i)
      EXPECT_EQ(votes[i].certified, expected[i].certified) << scale;
  }
}

TEST(EdgeCertificate, TakesPointsOnALine)
{
  Positions line;
  for (int i = 0; i < 20; ++i)
    line.push_back({0.3 * i, 0.7 * i, -0.2 * i});
  const RankedCloud cloud(line, 8);
  EXPECT_TRUE(certifies(cloud, 10, 11));
  EXPECT_FALSE(certifies(cloud, 10, 12));
}

TEST(EdgeCertificate, AShortRowVotesOnItsNeighborsOnly)
{
  const RankedCloud cloud({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 16);
  EXPECT_EQ(votesOf(cloud)[0].in_reach, 3u);
}

} // namespace
} // namespace pcl::ccaa::test
