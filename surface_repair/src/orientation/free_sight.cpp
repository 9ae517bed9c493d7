// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which side of an island the enclosing sphere sees (4.48).

#include "orientation/free_sight.h"

#include "field/shielding.h"
#include "mesh/corners.h"

#include <algorithm>
#include <cmath>

namespace pcl::repair {

namespace {

/** Directions from a lookout, on each side: more where an island has few lookouts. */
constexpr std::size_t LEAST_DIRECTIONS = 16;
constexpr std::size_t MOST_DIRECTIONS = 256;
constexpr std::size_t WAYS = 1024;
constexpr std::size_t MOST_SAMPLES = 64;
constexpr std::size_t LEAST_SAMPLES = 12;
constexpr std::size_t ALL_SAMPLES = 12800;

/** Turn from one sample to the next, so that no two look in the same directions. */
constexpr double GOLDEN_ANGLE = 2.39996322972865332;

/** A place on an island to look from. */
struct Lookout {
  std::size_t island = 0;
  Position position;
  Direction normal;
  std::size_t directions = LEAST_DIRECTIONS;
};

/** A tetrahedron around a free point whose faces are `clearance` from it. */
void
addObstacle(const Position& point, double clearance, IncompleteModel& obstacles)
{
  const auto first = static_cast<pcl::index_t>(obstacles.positions.size());
  const double reach = std::sqrt(3.0) * clearance;
  for (const Eigen::Vector3d& corner : {Eigen::Vector3d(1, 1, 1),
                                        Eigen::Vector3d(1, -1, -1),
                                        Eigen::Vector3d(-1, 1, -1),
                                        Eigen::Vector3d(-1, -1, 1)})
    obstacles.positions.push_back(point + reach * corner);
  for (const Triangle& face :
       {Triangle{0, 1, 2}, Triangle{0, 2, 3}, Triangle{0, 3, 1}, Triangle{1, 3, 2}})
    obstacles.triangles.push_back({first + face[0], first + face[1], first + face[2]});
}

/** All that may stand in the way: the surface, and the surroundings of free points. */
IncompleteModel
obstaclesOf(const IncompleteModel& model, double clearance)
{
  IncompleteModel obstacles;
  obstacles.positions = model.positions;
  obstacles.triangles = model.triangles;
  if (clearance > 0.0)
    for (const Position& point : model.free_points)
      addObstacle(point, clearance, obstacles);
  return obstacles;
}

/** Centres of triangles at equal steps of the island's running area. */
std::vector<Lookout>
chooseLookouts(const IncompleteModel& model)
{
  const std::size_t islands = model.islands.size();
  const std::size_t samples = std::clamp(
      ALL_SAMPLES / std::max<std::size_t>(islands, 1), LEAST_SAMPLES, MOST_SAMPLES);
  std::vector<double> passed(islands, 0.0);
  std::vector<std::size_t> taken(islands, 0);
  std::vector<Lookout> lookouts;
  for (std::size_t t = 0; t < model.triangles.size(); ++t) {
    const std::size_t island = model.island_of[t];
    const ccaa::Corners corners = ccaa::cornersOf(model.triangles[t], model.positions);
    const Eigen::Vector3d area = 0.5 * ccaa::areaNormal(corners);
    passed[island] += area.norm();
    const double due = (static_cast<double>(taken[island]) + 0.5) /
                       static_cast<double>(samples) * model.islands[island].area;
    if (passed[island] < due || !(area.norm() > 0.0))
      continue;
    ++taken[island];
    lookouts.push_back({island,
                        (corners[0] + corners[1] + corners[2]) / 3.0,
                        area.normalized(),
                        LEAST_DIRECTIONS});
  }
  for (Lookout& lookout : lookouts)
    lookout.directions =
        std::clamp(WAYS / taken[lookout.island], LEAST_DIRECTIONS, MOST_DIRECTIONS);
  return lookouts;
}

/** The k-th of the directions, spread over the half sphere around a normal, turned by
 * an angle of the lookout's own. */
Direction
directionOf(const Direction& normal, std::size_t k, std::size_t count, double turn)
{
  const double up = (static_cast<double>(k) + 0.5) / static_cast<double>(count);
  const double aside = std::sqrt(1.0 - up * up);
  const double angle = turn + static_cast<double>(k) * GOLDEN_ANGLE;
  const Direction first = normal.unitOrthogonal();
  const Direction second = normal.cross(first);
  return up * normal + aside * (std::cos(angle) * first + std::sin(angle) * second);
}

struct Horizon {
  double radius = 0.0;    /**< longer than any way inside the model */
  double tolerance = 0.0; /**< of the surface looked from */
};

FreeSight
lookFrom(const Lookout& lookout,
         std::size_t number,
         const Shield& shield,
         const Horizon& horizon)
{
  FreeSight sight;
  const double turn = static_cast<double>(number) * GOLDEN_ANGLE;
  for (const double side : {1.0, -1.0})
    for (std::size_t k = 0; k < lookout.directions; ++k) {
      const Direction direction =
          directionOf(side * lookout.normal, k, lookout.directions, turn);
      const double weight = std::abs(direction.dot(lookout.normal));
      if (side > 0.0)
        sight.asked += weight;
      const Position end = lookout.position + horizon.radius * direction;
      if (!shield.crosses(lookout.position, end, horizon.tolerance))
        sight.votes.add(side * weight);
    }
  return sight;
}

} // namespace

std::vector<FreeSight>
lookAround(const IncompleteModel& model,
           double clearance,
           const ccaa::LoopContext& context)
{
  const IncompleteModel obstacles = obstaclesOf(model, clearance);
  Eigen::AlignedBox3d box;
  for (const Position& position : obstacles.positions)
    box.extend(position);
  const Shield shield(obstacles, context.threads, context.control);
  const double diagonal = box.isEmpty() ? 0.0 : box.diagonal().norm();
  const Horizon horizon{1.01 * diagonal, 1e-6 * diagonal};

  const std::vector<Lookout> lookouts = chooseLookouts(model);
  std::vector<FreeSight> seen(lookouts.size());
  ccaa::LoopContext small_blocks = context;
  small_blocks.block_size = 64;
  ccaa::forEachBlock(lookouts.size(),
                     small_blocks,
                     [&](std::size_t, std::size_t begin, std::size_t end) {
                       for (std::size_t i = begin; i < end; ++i)
                         seen[i] = lookFrom(lookouts[i], i, shield, horizon);
                     });

  std::vector<FreeSight> sights(model.islands.size());
  for (std::size_t i = 0; i < seen.size(); ++i) {
    sights[lookouts[i].island].votes.add(seen[i].votes);
    sights[lookouts[i].island].asked += seen[i].asked;
  }
  return sights;
}

} // namespace pcl::repair
