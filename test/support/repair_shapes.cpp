// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: damaged surfaces, and what has to come of them.
#include "repair_shapes.h"

#include <Eigen/Geometry>

#include "random_source.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace pcl::ccaa::test {
namespace {

/** Smaller islands are crumbs of the cut, which nobody would keep. */
constexpr std::size_t FEWEST_TRIANGLES = 8;

/** Near the frame of `divisions` a square in space, its vertices by place. */
class Squares {
public:
  index_t
  vertex(const std::array<int, 3>& place)
  {
    const auto [found, is_new] =
        number_.emplace(place, static_cast<index_t>(shape_.vertices.size()));
    if (is_new)
      shape_.vertices.emplace_back(place[0], place[1], place[2]);
    return found->second;
  }

  /** The side of a cube that looks along an axis, up or down it. */
  void
  addSide(const std::array<int, 3>& cube, std::size_t axis, bool up)
  {
    const std::size_t u = (axis + 1) % 3;
    const std::size_t v = (axis + 2) % 3;
    std::array<int, 3> corner = cube;
    corner[axis] += up ? 1 : 0;
    std::array<index_t, 4> around{};
    around[0] = vertex(corner);
    ++corner[u];
    around[1] = vertex(corner);
    ++corner[v];
    around[2] = vertex(corner);
    --corner[u];
    around[3] = vertex(corner);
    if (!up)
      std::swap(around[1], around[3]);
    shape_.triangles.push_back({around[0], around[1], around[2]});
    shape_.triangles.push_back({around[0], around[2], around[3]});
  }

  Shape
  take()
  {
    return std::move(shape_);
  }

private:
  Shape shape_;
  std::map<std::array<int, 3>, index_t> number_;
};

/** Moves every vertex towards the mean of its neighbours, then back by more than a half
 * (Taubin): round, and hardly smaller. */
void
smooth(int rounds, Shape& shape)
{
  std::vector<std::set<index_t>> neighbors(shape.vertices.size());
  for (const Triangle& t : shape.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      neighbors[static_cast<std::size_t>(t[k])].insert(t[(k + 1) % 3]);
      neighbors[static_cast<std::size_t>(t[k])].insert(t[(k + 2) % 3]);
    }
  for (int round = 0; round < 2 * rounds; ++round) {
    const double step = round % 2 == 0 ? 0.5 : -0.52;
    const Positions before = shape.vertices;
    for (std::size_t i = 0; i < before.size(); ++i) {
      Position sum = Position::Zero();
      for (const index_t neighbor : neighbors[i])
        sum += before[static_cast<std::size_t>(neighbor)];
      const Position mean = sum / static_cast<double>(neighbors[i].size());
      shape.vertices[i] = before[i] + step * (mean - before[i]);
    }
  }
}

Eigen::Quaterniond
randomRotation(RandomSource& random)
{
  Eigen::Vector4d q;
  for (int i = 0; i < 4; ++i)
    q[i] = random.normal();
  return Eigen::Quaterniond(q.normalized());
}

} // namespace

Shape
withoutFreeVertices(const Shape& shape)
{
  std::vector<index_t> number(shape.vertices.size(), -1);
  for (const Triangle& triangle : shape.triangles)
    for (const index_t corner : triangle)
      number[static_cast<std::size_t>(corner)] = 0;
  Shape rest;
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i] < 0)
      continue;
    number[i] = static_cast<index_t>(rest.vertices.size());
    rest.vertices.push_back(shape.vertices[i]);
  }
  for (Triangle triangle : shape.triangles) {
    for (index_t& corner : triangle)
      corner = number[static_cast<std::size_t>(corner)];
    rest.triangles.push_back(triangle);
  }
  return rest;
}

Shape
inPieces(const Shape& shape, const PieceOf& piece_of, bool keep_lost_points)
{
  std::vector<int> pieces;
  for (const Position& position : shape.vertices)
    pieces.push_back(piece_of(position));
  Shape rest{shape.vertices, {}};
  for (const Triangle& triangle : shape.triangles) {
    const int piece = pieces[static_cast<std::size_t>(triangle[0])];
    if (piece >= 0 &&
        std::all_of(triangle.begin(), triangle.end(), [&](index_t corner) {
          return pieces[static_cast<std::size_t>(corner)] == piece;
        }))
      rest.triangles.push_back(triangle);
  }
  rest.triangles = manifoldPart(std::move(rest.triangles), FEWEST_TRIANGLES);
  return keep_lost_points ? rest : withoutFreeVertices(rest);
}

PieceOf
cells(std::size_t count, double gap, std::uint64_t seed)
{
  RandomSource random(seed);
  const Eigen::Quaterniond rotation = randomRotation(random);
  Positions middles; // a spiral of equal areas
  for (std::size_t i = 0; i < count; ++i) {
    const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    const double height = 1.0 - 2.0 * share;
    const double radius = std::sqrt(1.0 - height * height);
    const double angle = M_PI * (3.0 - std::sqrt(5.0)) * static_cast<double>(i);
    const Position middle(radius * std::cos(angle), radius * std::sin(angle), height);
    middles.push_back(rotation *
                      (count == 2 ? Position(0, 0, i == 0 ? 1 : -1) : middle));
  }
  return [middles, gap](const Position& place) {
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < middles.size(); ++i)
      if ((place - middles[i]).norm() < (place - middles[nearest]).norm())
        nearest = i;
    for (std::size_t i = 0; i < middles.size(); ++i) {
      const Position across = middles[nearest] - middles[i];
      if (i != nearest && place.dot(across.normalized()) < 0.5 * gap)
        return -1;
    }
    return static_cast<int>(nearest);
  };
}

Shape
gradedSphere(int subdivisions, double factor)
{
  // In the stereographic plane a stretch by k makes edges k times as long at one pole
  // and 1/k times at the other; as every similarity there it keeps angles.
  const double k = std::sqrt(factor);
  Shape shape = icosphere(subdivisions);
  for (Position& p : shape.vertices) {
    const double up = 1.0 + p.z();
    const double down = 1.0 - p.z();
    const double stretched = k * k * down;
    const double scale = 2.0 * k / (up + stretched);
    p = Position(p.x() * scale, p.y() * scale, (up - stretched) / (up + stretched));
    p.normalize();
  }
  return shape;
}

Shape
frame(int divisions)
{
  const auto is_inside = [divisions](const std::array<int, 3>& cube) {
    const auto square = [divisions](int i) { return i < 0 ? -1 : i / divisions; };
    const int column = square(cube[0]);
    const int row = square(cube[1]);
    if (column < 0 || column > 4 || row < 0 || row > 2 || square(cube[2]) != 0)
      return false;
    return row != 1 || column % 2 == 0;
  };
  Squares squares;
  for (int x = 0; x < 5 * divisions; ++x)
    for (int y = 0; y < 3 * divisions; ++y)
      for (int z = 0; z < divisions; ++z)
        for (std::size_t axis = 0; axis < 3; ++axis)
          for (const bool up : {false, true}) {
            const std::array<int, 3> cube{x, y, z};
            std::array<int, 3> next = cube;
            next[axis] += up ? 1 : -1;
            if (is_inside(cube) && !is_inside(next))
              squares.addSide(cube, axis, up);
          }
  Shape shape = squares.take();
  smooth(2 * divisions, shape);
  for (Position& p : shape.vertices)
    p = p / divisions - Position(2.5, 1.5, 0.5);
  return shape;
}

Shape
saddle(int divisions)
{
  Shape shape = grid(divisions + 1, divisions + 1);
  for (Position& p : shape.vertices) {
    p = 2.0 * p / divisions - Position(1.0, 1.0, 0.0);
    p.z() = 0.5 * (p.x() * p.x() - p.y() * p.y());
  }
  return shape;
}

std::vector<RepairCase>
allRepairCases(std::uint64_t seed)
{
  std::vector<RepairCase> all;
  for (const auto& list : {casesInPieces(seed),
                           casesWithHoles(seed),
                           openCases(seed),
                           unusualCases(seed),
                           casesWithFreePoints(seed)})
    all.insert(all.end(), list.begin(), list.end());
  return all;
}

} // namespace pcl::ccaa::test
