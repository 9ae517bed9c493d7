// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of the order along a space-filling curve.
#include <gtest/gtest.h>

#include "mesh/curve_order.h"
#include "surface_ccaa/search/search_inputs.h"

#include <numeric>

namespace pcl::ccaa::test {
namespace {

bool
isFinitePoint(const float* p)
{
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

std::vector<index_t>
finiteIndices(const PointArray& points)
{
  std::vector<index_t> finite;
  for (index_t i = 0; i < static_cast<index_t>(points.size); ++i)
    if (isFinitePoint(points[i]))
      finite.push_back(i);
  return finite;
}

std::vector<float>
coordinatesOf(const PointArray& points, index_t i)
{
  return {points[i][0], points[i][1], points[i][2]};
}

/** Distinct points counted without the curve. */
std::size_t
countDistinct(const PointArray& points, const std::vector<index_t>& chosen)
{
  std::vector<std::vector<float>> all;
  for (const index_t i : chosen)
    all.push_back(coordinatesOf(points, i));
  std::sort(all.begin(), all.end());
  return static_cast<std::size_t>(std::unique(all.begin(), all.end()) - all.begin());
}

double
lengthAlong(const PointArray& points, const std::vector<index_t>& order)
{
  double length = 0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    const float* a = points[order[i - 1]];
    const float* b = points[order[i]];
    length += std::hypot(double(a[0] - b[0]), double(a[1] - b[1]), double(a[2] - b[2]));
  }
  return length;
}

TEST(CurveOrder, IsAPermutationOfTheFinitePoints)
{
  for (const NamedInput& input : allInputs()) {
    const PointArray points = arrayOf(input.coordinates);
    std::vector<index_t> order = curveOrder(points, 1);
    std::sort(order.begin(), order.end());
    EXPECT_EQ(order, finiteIndices(points)) << input.name;
  }
}

TEST(CurveOrder, IsTheSameForAnyNumberOfThreads)
{
  std::vector<NamedInput> inputs = allInputs();
  inputs.push_back({"Large", toCoordinates(bumpySphere(60000))});
  for (const NamedInput& input : inputs) {
    const PointArray points = arrayOf(input.coordinates);
    const std::vector<index_t> order = curveOrder(points, 1);
    EXPECT_EQ(order, curveOrder(points, 2)) << input.name;
    EXPECT_EQ(order, curveOrder(points, 7)) << input.name;
  }
}

TEST(CurveOrder, PutsEqualPointsTogetherByIndex)
{
  for (const NamedInput& input : allInputs()) {
    const PointArray points = arrayOf(input.coordinates);
    const std::vector<index_t> order = curveOrder(points, 1);
    std::size_t runs = order.empty() ? 0 : 1;
    for (std::size_t i = 1; i < order.size(); ++i)
      if (coordinatesOf(points, order[i - 1]) == coordinatesOf(points, order[i]))
        EXPECT_LT(order[i - 1], order[i]) << input.name;
      else
        ++runs;
    EXPECT_EQ(runs, countDistinct(points, order)) << input.name;
  }
}

TEST(CurveOrder, KeepsLowestIndexOfEqualPoints)
{
  const Coordinates coordinates =
      toCoordinates({{1, 0, 0}, {5, 5, 5}, {1, 0, 0}, {0, 0, 0}, {5, 5, 5}, {5, 5, 5}});
  const PointArray points = arrayOf(coordinates);
  std::vector<index_t> unique = removeDuplicates(points, curveOrder(points, 1));
  std::sort(unique.begin(), unique.end());
  EXPECT_EQ(unique, (std::vector<index_t>{0, 1, 3}));
}

TEST(CurveOrder, TakesNegativeZeroForZero)
{
  const Coordinates coordinates = {0.f, 0.f, 1.f, -0.f, 0.f, 1.f, 0.f, -0.f, 1.f};
  const PointArray points = arrayOf(coordinates);
  EXPECT_EQ(removeDuplicates(points, curveOrder(points, 1)), std::vector<index_t>{0});
}

TEST(CurveOrder, OrdersOnlyTheSelection)
{
  const Coordinates coordinates = toCoordinates(noisySphere(500, 0.01));
  const Indices selection = {400, 3, 77, 12, 13};
  std::vector<index_t> order = curveOrder(arrayOf(coordinates), selection, 1);
  std::sort(order.begin(), order.end());
  EXPECT_EQ(order, (std::vector<index_t>{3, 12, 13, 77, 400}));
}

TEST(CurveOrder, HasNeighborsInARow)
{
  const std::size_t count = 10000;
  const Coordinates coordinates = toCoordinates(shuffled(fibonacciSphere(count), 4));
  const PointArray points = arrayOf(coordinates);
  const double spacing = std::sqrt(4 * M_PI / double(count));
  EXPECT_LT(lengthAlong(points, curveOrder(points, 1)), 2 * spacing * double(count));
}

TEST(CurveOrder, KeepsNeighborsInARowDespiteAnOutlier)
{
  Positions sphere = shuffled(fibonacciSphere(10000), 4);
  const Coordinates alone = toCoordinates(sphere);
  sphere.push_back({1e30, 0, 0});
  const Coordinates with_outlier = toCoordinates(sphere);
  std::vector<index_t> order = curveOrder(arrayOf(with_outlier), 1);
  order.erase(std::find(order.begin(), order.end(), 10000));
  const double length = lengthAlong(arrayOf(alone), curveOrder(arrayOf(alone), 1));
  EXPECT_LT(lengthAlong(arrayOf(alone), order), 1.2 * length);
}

TEST(CurveOrder, VisitsNeighboringCellsInARow)
{
  const Coordinates coordinates = toCoordinates(shuffled(lattice(16), 9));
  const PointArray points = arrayOf(coordinates);
  EXPECT_NEAR(lengthAlong(points, curveOrder(points, 1)), 4095, 1200);
}

TEST(CurveOrder, CopesWithAMillionIdenticalPoints)
{
  const Coordinates coordinates(3 * 1000000, 0.5f);
  const PointArray points = arrayOf(coordinates);
  std::vector<index_t> all(1000000);
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(curveOrder(points, 2), all);
}

/** The order of places that lie in a row in memory. */
std::vector<index_t>
orderOf(const Positions& places)
{
  return curveOrder(
      places.size(), [&](std::size_t i) { return places[i]; }, 1);
}

TEST(CurveOrder, OfPlacesDoesNotDependOnWhereTheyLie)
{
  const Positions near = lattice(8);
  Positions far = near;
  for (Position& place : far)
    place +=
        Position(1099511627776.0, -1099511627776.0, 0.0); // 2^40: nothing is rounded
  EXPECT_EQ(orderOf(near), orderOf(far));
}

TEST(CurveOrder, OfPlacesHasAllThatAreFinite)
{
  const double huge = std::numeric_limits<double>::max();
  const double infinite = std::numeric_limits<double>::infinity();
  std::vector<index_t> order = orderOf(
      {{huge, 0, 0}, {infinite, 0, 0}, {-huge, 0, 0}, {0, std::nan(""), 0}, {1, 2, 3}});
  std::sort(order.begin(), order.end());
  EXPECT_EQ((std::vector<index_t>{0, 2, 4}), order);
}

} // namespace
} // namespace pcl::ccaa::test
