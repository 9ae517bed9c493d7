// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: closing whole loops of the front.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "advancing_front/gap_growth.h"
#include "advancing_front/loop_closure.h"
#include "mesh/sort_unique.h"
#include "open_shapes.h"
#include "support/edge_sets.h"
#include "support/mesh_asserts.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

namespace pcl::ccaa::test {
namespace {

using Outcome = LoopClosure::Outcome;

/** A shape with a hole whose loop is to be closed. */
class Hole {
public:
  /** \param[in] corner a vertex of the shape on the loop, with one fan */
  Hole(const Shape& shape, index_t corner)
  : open_(openSurfaceOf(shape, vertices_))
  , surface_(open_)
  , trial_(open_, surface_, 2.0, nullptr)
  , closure_(surface_, trial_)
  , corner_(std::find(vertices_.begin(), vertices_.end(), corner) - vertices_.begin())
  , before_(surface_.triangles().size())
  {}

  Outcome
  close()
  {
    FrontIndex edge = FrontEdge::NONE;
    surface_.front().forEdgesFrom(static_cast<index_t>(corner_),
                                  [&](FrontIndex i) { edge = i; });
    return closure_.close(edge);
  }

  /** \brief What closing has added, in the numbers of the shape. */
  Triangles
  added() const
  {
    Triangles added(surface_.triangles().begin() + static_cast<std::ptrdiff_t>(before_),
                    surface_.triangles().end());
    for (Triangle& t : added)
      for (index_t& vertex : t)
        vertex = vertices_[std::size_t(vertex)];
    return added;
  }

  std::size_t
  corners() const
  {
    return closure_.corners().size();
  }

  void
  setLargestRoom(double room)
  {
    open_.largest_room = room;
  }

private:
  std::vector<index_t> vertices_;
  OpenSurface open_;
  GrowingSurface surface_;
  TriangleTrial trial_;
  LoopClosure closure_;
  std::ptrdiff_t corner_;
  std::size_t before_;
};

/** Boundary edges of a sphere without two triangles after closing between some corners
 * of the first. */
std::size_t
boundaryAfterClosing(std::size_t corners)
{
  Shape sphere = icosphere(3);
  std::vector<index_t> open(sphere.triangles[0].begin(), sphere.triangles[0].end());
  std::sort(open.begin(), open.end());
  open.resize(corners);
  sphere.triangles.erase(sphere.triangles.begin());
  sphere.triangles.pop_back();
  PartialShape partial(sphere);
  const AliveFlags alive(sphere.triangles.size(), 1);
  const NearbyTriangles nearby(sphere.triangles, alive, sphere.vertices, open, 0.5);
  EXPECT_EQ(closeBetween(
                open, Gap(), nearby, CompletionParameters(), partial.surface, nullptr),
            corners == 3);
  return countBoundaryEdges(liveTriangles(partial.surface));
}

/** New edges along a gap are long, and would tell that the sampling is so. */
TEST(CloseBetween, TakesTheSpacingFromBeforeGrowth)
{
  for (const double spacing : {0.01, 1.0}) {
    Shape sphere = icosphere(3);
    const index_t lost = 20;
    Gap grown;
    std::vector<std::size_t> removed;
    for (std::size_t t = 0; t < sphere.triangles.size(); ++t)
      if (const Triangle& corners = sphere.triangles[t];
          std::count(corners.begin(), corners.end(), lost) > 0) {
        removed.push_back(t);
        std::remove_copy(
            corners.begin(), corners.end(), std::back_inserter(grown.open), lost);
      }
    sortUnique(grown.open);
    grown.surface.spacings.assign(grown.open.size(), spacing);
    sphere = withoutTriangles(sphere, removed);
    PartialShape partial(sphere);
    const AliveFlags alive(sphere.triangles.size(), 1);
    const NearbyTriangles nearby(
        sphere.triangles, alive, sphere.vertices, grown.open, 0.5);
    EXPECT_EQ(closeBetween(grown.open,
                           grown,
                           nearby,
                           CompletionParameters(),
                           partial.surface,
                           nullptr),
              spacing > 0.1);
  }
}

TEST(CloseBetween, ClosesLoopsOfWhichAllCornersAreOpen)
{
  EXPECT_EQ(boundaryAfterClosing(0), 6U);
  EXPECT_EQ(boundaryAfterClosing(2), 6U);
  EXPECT_EQ(boundaryAfterClosing(3), 3U);
}

/** The triangles with a corner that is to go, and these vertices far away. */
Shape
without(Shape shape, const std::function<bool(const Position&)>& goes)
{
  std::vector<std::size_t> removed;
  for (std::size_t t = 0; t < shape.triangles.size(); ++t)
    for (const index_t corner : shape.triangles[t])
      if (goes(shape.vertices[std::size_t(corner)])) {
        removed.push_back(t);
        break;
      }
  shape = withoutTriangles(shape, removed);
  for (Position& vertex : shape.vertices)
    if (goes(vertex))
      vertex.z() = 1000.0;
  return shape;
}

/** The first vertex nearest to a place that has triangles. */
index_t
nearestUsed(const Shape& shape, const Position& place)
{
  index_t nearest = shape.triangles.front()[0];
  for (const Triangle& t : shape.triangles)
    for (const index_t corner : t)
      if ((shape.vertices[std::size_t(corner)] - place).norm() <
          (shape.vertices[std::size_t(nearest)] - place).norm())
        nearest = corner;
  return nearest;
}

Hole
discHole(double radius)
{
  const Position middle(15, 15, 0);
  const Shape shape = without(
      grid(31, 31), [&](const Position& p) { return (p - middle).norm() < radius; });
  return {shape, nearestUsed(shape, middle)};
}

TEST(LoopClosure, NeedsTwoTrianglesLessThanAFlatLoopHasEdges)
{
  for (const double radius : {0.5, 1.2}) {
    Hole hole = discHole(radius);
    EXPECT_EQ(hole.close(), Outcome::CLOSED) << radius;
    EXPECT_EQ(hole.added().size(), hole.corners() - 2) << radius;
  }
}

TEST(LoopClosure, LeavesOpenWhatGetsTooFarFromSamples)
{
  for (const double room : {1.5, 2.5}) {
    Hole hole = discHole(1.5);
    hole.setLargestRoom(room);
    EXPECT_EQ(hole.close(), room < 2.0 ? Outcome::UNSUPPORTED : Outcome::CLOSED);
  }
}

/** Each fan at it is closed by a loop of its own, and the point has two all the same.
 */
TEST(CloseLoops, TellPointsThatSeveralFansShareAlsoIfAllLoopsAreClosed)
{
  const Shape ball = icosphere(2);
  const index_t shared = ball.triangles[0][0];
  const Position& place = ball.vertices[std::size_t(shared)];
  Shape pair = joined(ball, translated(ball, 2.0 * place));
  const auto opposite =
      static_cast<index_t>(nearestUsed(translated(ball, 2.0 * place), place) +
                           index_t(ball.vertices.size()));
  for (Triangle& triangle : pair.triangles)
    std::replace(triangle.begin(), triangle.end(), opposite, shared);
  const auto isThere = [&](const Triangle& t) {
    return std::find(t.begin(), t.end(), shared) != t.end();
  };
  pair.triangles.erase(
      std::find_if(pair.triangles.begin() + std::ptrdiff_t(ball.triangles.size()),
                   pair.triangles.end(),
                   isThere));
  pair.triangles.erase(pair.triangles.begin());
  std::vector<index_t> vertices;
  const OpenSurface open = openSurfaceOf(pair, vertices);
  GrowingSurface surface(open);
  TriangleTrial trial(open, surface, 2.0, nullptr);
  const std::vector<index_t> obstructed = closeLoops(surface, trial, nullptr);
  EXPECT_EQ(surface.triangles().size(), open.rim.size() + 2);
  ASSERT_EQ(obstructed.size(), 1u);
  EXPECT_EQ(vertices[std::size_t(obstructed[0])], shared);
}

TEST(LoopClosure, LeavesNoBorderAndNoCrossing)
{
  const Shape shape = withoutPatches(icosphere(3), 1, 0, 2);
  PartialShape partial(shape);
  index_t corner = 0;
  while (partial.adjacency.fan(corner) != Fan::OPEN)
    ++corner;
  Hole hole(shape, corner);
  EXPECT_EQ(hole.close(), Outcome::CLOSED);
  Triangles whole = shape.triangles;
  for (const Triangle& t : hole.added())
    whole.push_back(t);
  EXPECT_EQ(countBoundaryEdges(whole), 0u);
  EXPECT_TRUE(isConsistentlyWound(whole));
  EXPECT_TRUE(isIcadm(whole, shape.vertices.size()));
}

Position
normalOf(const Shape& shape, const Triangle& t)
{
  const Position& a = shape.vertices[std::size_t(t[0])];
  return (shape.vertices[std::size_t(t[1])] - a)
      .cross(shape.vertices[std::size_t(t[2])] - a)
      .normalized();
}

/** Largest angle between two neighbors of which at least one is in the patch. */
double
largestFold(const Shape& shape, const Triangles& patch)
{
  Triangles all = shape.triangles;
  all.insert(all.end(), patch.begin(), patch.end());
  double least = 1.0;
  for (const Triangle& one : patch)
    for (const Triangle& other : all) {
      const auto shared = std::count_if(one.begin(), one.end(), [&](index_t v) {
        return std::find(other.begin(), other.end(), v) != other.end();
      });
      if (shared == 2)
        least = std::min(least, normalOf(shape, one).dot(normalOf(shape, other)));
    }
  return std::acos(std::clamp(least, -1.0, 1.0));
}

TEST(LoopClosure, PicksTheDiagonalThatFoldsLess)
{
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Shape shape = grid(6, 6);
    RandomSource random(seed);
    for (Position& vertex : shape.vertices)
      vertex.z() = random.uniform(-0.35, 0.35);
    const index_t a = 14, b = 15, c = 21, d = 20; // the square in the middle
    shape.triangles.erase(
        std::remove_if(shape.triangles.begin(),
                       shape.triangles.end(),
                       [&](const Triangle& t) {
                         return std::all_of(t.begin(), t.end(), [&](index_t v) {
                           return v == a || v == b || v == c || v == d;
                         });
                       }),
        shape.triangles.end());
    ASSERT_EQ(shape.triangles.size(), 48u);
    Hole hole(shape, a);
    ASSERT_EQ(hole.close(), Outcome::CLOSED) << seed;
    const Triangles one{{a, b, c}, {a, c, d}}, other{{a, b, d}, {b, c, d}};
    const double fold = largestFold(shape, one), other_fold = largestFold(shape, other);
    EXPECT_TRUE(sameTriangles(fold < other_fold ? one : other, hole.added())) << seed;
  }
}

TEST(LoopClosure, LeavesALoopOpenThatIsTooWideForItsSamples)
{
  Hole hole = discHole(5.0);
  EXPECT_EQ(hole.close(), Outcome::UNSUPPORTED);
  EXPECT_TRUE(hole.added().empty());
}

TEST(LoopClosure, LeavesALoopOpenThatHasTooManyEdges)
{
  Shape shape = withoutTriangles(grid(40, 3), {});
  Hole hole(shape, 0); // around the grid: 82 edges
  EXPECT_EQ(hole.close(), Outcome::UNSUPPORTED);
  EXPECT_TRUE(hole.added().empty());
}

TEST(LoopClosure, LeavesALoopOpenInWhoseWayATriangleStands)
{
  Shape shape = grid(6, 6);
  shape.triangles.erase(shape.triangles.begin() + 24, shape.triangles.begin() + 26);
  const auto wall = static_cast<index_t>(shape.vertices.size());
  shape.vertices.insert(shape.vertices.end(),
                        {{2.5, 2.5, -0.4}, {2.6, 2.4, 0.5}, {2.4, 2.6, 0.5}});
  const index_t corner = 14;
  shape.triangles.push_back({wall, wall + 1, wall + 2});
  Hole hole(shape, corner);
  EXPECT_EQ(hole.close(), Outcome::OBSTRUCTED);
  EXPECT_EQ(hole.corners(), 4u);
  EXPECT_TRUE(hole.added().empty());
}

TEST(LoopClosure, DoesNotMakeTheBackOfASingleTriangle)
{
  Hole hole({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}, 0);
  EXPECT_NE(hole.close(), Outcome::CLOSED);
  EXPECT_TRUE(hole.added().empty());
}

TEST(LoopClosure, DoesNotUseAnEdgeThatIsThere)
{
  // the lid of a tetrahedron without two sides: the only diagonals are its edges
  const Shape shape{tetrahedron().vertices, {{0, 2, 1}, {0, 1, 3}}};
  Hole hole(shape, 2);
  EXPECT_EQ(hole.close(), Outcome::CLOSED);
  EXPECT_TRUE(sameTriangles({{0, 3, 2}, {1, 2, 3}}, hole.added()));
}

} // namespace
} // namespace pcl::ccaa::test
