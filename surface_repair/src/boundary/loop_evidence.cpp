// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what speaks for a hole and what for a rim.
#include "boundary/loop_evidence.h"

#include "boundary/extraction.h"
#include "mesh/corners.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::repair {
namespace {

/** Weights of D and of turning; the area counts in powers of two. */
constexpr double INTEGRAL_WEIGHT = 2.0;
constexpr double TURNING_WEIGHT = 1.0;
/** Half a sphere: as much a hole as a rim. */
constexpr double EVEN_RATIO = 2.0;
/** What a second mouth takes from the evidence of a large island: a tube may be long.
 */
constexpr double TUBE_DISCOUNT = 2.5;
/** Share of the larger mouth's area that the other mouth of a tube has. */
constexpr double TWIN_SHARE = 0.5;
/** D by length, and turns, of what may be a stump: a hole in a surface has 1 of both,
 * the mouth of a tube 0. */
constexpr double STUMP_INTEGRAL = 0.6;
constexpr double STUMP_TURNING = 0.7;
/** Both, of the mouth of a tube. */
constexpr double MOUTH = 0.35;
/** A jagged mouth turns more than a smooth one. */
constexpr double MOUTH_TURNING = 0.5;
/** The course of a mouth says less than this for a hole or a rim. */
constexpr double MOUTH_COURSE = 0.75;

/** \brief The angle by which a curve turns to the left where edge k begins. */
double
leftTurnAt(const BoundaryCurve& curve, std::size_t k)
{
  const std::size_t before = (k == 0 ? curve.size() : k) - 1;
  const Eigen::Vector3d in = curve.edge(before);
  const Eigen::Vector3d out = curve.edge(k);
  const Direction normal = (curve.normals[before] + curve.normals[k]).normalized();
  return std::atan2(normal.dot(in.cross(out)), in.dot(out));
}

/** \brief The possible value nearest to EVEN_RATIO: what is not known speaks for
 * neither side. */
double
areaRatio(double area, const AreaBounds& closing)
{
  if (area > EVEN_RATIO * closing.upper)
    return area / std::max(closing.upper, std::numeric_limits<double>::min());
  if (area < EVEN_RATIO * closing.lower)
    return area / closing.lower;
  return EVEN_RATIO;
}

/** \brief The loops of one island. */
struct IslandLoops {
  std::vector<std::size_t> loops; /**< the largest area first */
  double closing_area = 0.0;      /**< of all, lower bounds */
  long euler_characteristic = 0;
};

/** \brief Vertices less edges plus triangles of each island. */
void
countEuler(const IncompleteModel& model,
           const BoundaryLoops& loops,
           std::vector<IslandLoops>& islands)
{
  for (std::size_t v = 0; v < model.positions.size(); ++v) {
    const pcl::index_t triangle = *model.adjacency.begin(static_cast<pcl::index_t>(v));
    ++islands[model.island_of[static_cast<std::size_t>(triangle)]].euler_characteristic;
  }
  std::vector<std::size_t> edge_ends(islands.size(), 0);
  for (std::size_t i = 0; i < islands.size(); ++i) {
    edge_ends[i] = 3 * model.islands[i].triangles;
    islands[i].euler_characteristic += static_cast<long>(model.islands[i].triangles);
  }
  for (const BoundaryLoop& loop : loops)
    edge_ends[loop.island] += loop.vertices.size(); // a border has one end only
  for (const auto& [vertex, kept] : pinchedVertices(model, loops)) {
    const pcl::index_t triangle = *model.adjacency.begin(vertex);
    --islands[model.island_of[static_cast<std::size_t>(triangle)]].euler_characteristic;
  }
  for (std::size_t i = 0; i < islands.size(); ++i)
    islands[i].euler_characteristic -= static_cast<long>(edge_ends[i] / 2);
}

std::vector<IslandLoops>
listLoops(const IncompleteModel& model,
          const BoundaryLoops& loops,
          const std::vector<AreaBounds>& closing)
{
  std::vector<IslandLoops> islands(model.islands.size());
  for (std::size_t i = 0; i < loops.size(); ++i) {
    islands[loops[i].island].loops.push_back(i);
    islands[loops[i].island].closing_area += closing[i].lower;
  }
  for (IslandLoops& island : islands)
    std::stable_sort(
        island.loops.begin(), island.loops.end(), [&](std::size_t a, std::size_t b) {
          return closing[a].lower > closing[b].lower;
        });
  countEuler(model, loops, islands);
  return islands;
}

/** \brief Turning as far as it can be believed. A loop that turns more than once says
 * more about the roughness of the surface beside it than about itself. */
double
believedTurning(double turning)
{
  return std::abs(turning) <= 1.0 ? turning : 1.0 / (turning * std::abs(turning));
}

/** \brief What the loop's own course says: above 0 a hole. */
double
courseOf(const LoopEvidence& evidence)
{
  return INTEGRAL_WEIGHT * evidence.integral.relative() +
         TURNING_WEIGHT * believedTurning(evidence.turning);
}

/** \brief Whether an island is a tube but for holes that are smaller than its mouths.
 */
bool
isTube(const IslandLoops& island,
       const std::vector<AreaBounds>& closing,
       const std::vector<LoopEvidence>& evidence)
{
  const auto count = static_cast<long>(island.loops.size());
  if (count < 2 || island.euler_characteristic != 2 - count) // a sphere with openings
    return false;
  const auto area = [&](std::size_t rank) { return closing[island.loops[rank]].lower; };
  const auto is_mouth = [&](std::size_t rank) {
    return std::abs(courseOf(evidence[island.loops[rank]])) < MOUTH_COURSE;
  };
  return is_mouth(0) && is_mouth(1) && area(1) > TWIN_SHARE * area(0) &&
         (count == 2 || area(2) < TWIN_SHARE * area(1));
}

/** \brief Mark what lies within a rim: the clearest rim of an island encloses the rest
 * of it, so a loop of less than half its area is no second one. */
void
markWithinRim(const IslandLoops& island,
              const std::vector<AreaBounds>& closing,
              std::vector<LoopEvidence>& evidence)
{
  if (island.loops.size() < 2)
    return;
  const std::size_t rim = *std::min_element(
      island.loops.begin(), island.loops.end(), [&](std::size_t a, std::size_t b) {
        return evidence[a].score() < evidence[b].score();
      });
  if (evidence[rim].score() >= 0.0)
    return;
  for (const std::size_t loop : island.loops)
    evidence[loop].within_rim =
        loop != rim && closing[loop].lower < TWIN_SHARE * closing[rim].lower;
}

} // namespace

double
LoopEvidence::score() const
{
  double size = std::log2(area_ratio / EVEN_RATIO);
  if (is_tube_mouth && size > 0.0)
    size = std::max(0.0, size - TUBE_DISCOUNT);
  const double sum = courseOf(*this) + size;
  return within_rim ? std::max(0.0, sum) : sum;
}

double
turningOf(const IncompleteModel& model, const BoundaryLoop& loop)
{
  double lacking = 0.0;
  for (std::size_t k = 0; k < loop.vertices.size(); ++k) {
    const pcl::index_t vertex = loop.vertices[k];
    if (vertexBefore(model, loop, k) != vertex) { // its triangles lie on two sides
      lacking += leftTurnAt(loop.curve, k);
      continue;
    }
    lacking += M_PI;
    for (const pcl::index_t* triangle = model.adjacency.begin(vertex);
         triangle != model.adjacency.end(vertex);
         ++triangle)
      lacking -= ccaa::angleAt(model.triangles[static_cast<std::size_t>(*triangle)],
                               vertex,
                               model.positions);
  }
  return -lacking / (2.0 * M_PI);
}

double
turningOf(const BoundaryCurve& curve)
{
  double left = 0.0;
  for (std::size_t k = 0; k < curve.size(); ++k)
    left += leftTurnAt(curve, k);
  return -left / (2.0 * M_PI);
}

LoopEvidence
evidenceOf(const BoundaryCurve& curve, double area)
{
  LoopEvidence evidence;
  evidence.integral = boundaryIntegral(curve);
  evidence.turning = turningOf(curve);
  evidence.area_ratio = areaRatio(area, leastSurface(curve));
  return evidence;
}

bool
mayBeStump(const LoopEvidence& evidence)
{
  return evidence.integral.relative() < STUMP_INTEGRAL &&
         evidence.turning < STUMP_TURNING;
}

bool
isMouth(const LoopEvidence& evidence)
{
  return std::abs(evidence.integral.relative()) < MOUTH &&
         std::abs(evidence.turning) < MOUTH_TURNING;
}

AreaBounds
leastSurface(const BoundaryCurve& curve)
{
  AreaBounds bounds;
  const double length = lengthOf(curve);
  if (!(length > 0.0))
    return bounds;
  Position centroid = Position::Zero();
  for (std::size_t k = 0; k < curve.size(); ++k)
    centroid += 0.5 * (curve.points[k] + curve.points[curve.next(k)]) *
                (curve.edge(k).norm() / length);
  Eigen::Vector3d vector_area = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < curve.size(); ++k) {
    const Eigen::Vector3d piece =
        0.5 *
        (curve.points[k] - centroid).cross(curve.points[curve.next(k)] - centroid);
    vector_area += piece;
    bounds.upper += piece.norm();
  }
  bounds.lower = vector_area.norm();
  // No least surface has more than a disc (isoperimetric inequality).
  bounds.upper = std::min(bounds.upper, length * length / (4.0 * M_PI));
  return bounds;
}

std::vector<LoopEvidence>
collectEvidence(const IncompleteModel& model,
                const BoundaryLoops& loops,
                const ccaa::LoopContext& context)
{
  std::vector<LoopEvidence> all(loops.size());
  std::vector<AreaBounds> closing(loops.size());
  const auto look = [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      all[i].integral = boundaryIntegral(loops[i].curve);
      all[i].turning = turningOf(model, loops[i]);
      closing[i] = leastSurface(loops[i].curve);
    }
  };
  if (!ccaa::forEachBlock(loops.size(), context, look))
    return all;
  const std::vector<IslandLoops> islands = listLoops(model, loops, closing);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const std::size_t island = loops[i].island;
    const double others = islands[island].closing_area - closing[i].lower;
    all[i].area_ratio = areaRatio(model.islands[island].area + others, closing[i]);
  }
  for (const IslandLoops& island : islands) {
    if (isTube(island, closing, all))
      all[island.loops[0]].is_tube_mouth = all[island.loops[1]].is_tube_mouth = true;
    markWithinRim(island, closing, all);
  }
  return all;
}

} // namespace pcl::repair
