// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what speaks for a hole and what for a rim.
#include "loop_evidence.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace repair {
namespace {

/** Weights of D and of turning; the area counts in powers of two. */
constexpr double INTEGRAL_WEIGHT = 2.0;
constexpr double TURNING_WEIGHT = 1.0;
/** Half a sphere: as much a hole as a rim. */
constexpr double EVEN_RATIO = 2.0;
/** What a twin takes from the evidence of a large island: a tube may be long. */
constexpr double TWIN_DISCOUNT = 2.5;
/** Share of a loop's area from which another loop is its twin. */
constexpr double TWIN_SHARE = 0.5;

double
angleAt(const IncompleteModel& model, pcl::index_t triangle, pcl::index_t vertex)
{
  const Triangle& corners = model.triangles[static_cast<std::size_t>(triangle)];
  const auto at = [&](std::size_t corner) -> const Position& {
    return model.positions[static_cast<std::size_t>(corners[corner % 3])];
  };
  std::size_t corner = 0;
  while (corners[corner] != vertex)
    ++corner;
  const Position one = at(corner + 1) - at(corner);
  const Position other = at(corner + 2) - at(corner);
  return std::atan2(one.cross(other).norm(), one.dot(other));
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

/** \brief Loops of each island, and what closing all of them would add. */
struct IslandLoops {
  double closing_area = 0.0; /**< lower bounds */
  double largest = 0.0;      /**< of the areas */
  double second = 0.0;
};

std::vector<IslandLoops>
sumLoops(const IncompleteModel& model,
         const BoundaryLoops& loops,
         const std::vector<AreaBounds>& closing)
{
  std::vector<IslandLoops> sums(model.islands.size());
  for (std::size_t i = 0; i < loops.size(); ++i) {
    IslandLoops& sum = sums[loops[i].island];
    const double area = closing[i].lower;
    sum.closing_area += area;
    sum.second = std::max(sum.second, std::min(area, sum.largest));
    sum.largest = std::max(sum.largest, area);
  }
  return sums;
}

/** \brief Whether some other loop of the island is neither much smaller nor much
 * larger.
 */
bool
hasTwin(double area, const IslandLoops& island)
{
  const double other = area < island.largest ? island.largest : island.second;
  return std::min(area, other) > TWIN_SHARE * std::max(area, other);
}

} // namespace

double
LoopEvidence::score() const
{
  double size = std::log2(area_ratio / EVEN_RATIO);
  if (has_twin && size > 0.0)
    size = std::max(0.0, size - TWIN_DISCOUNT);
  return INTEGRAL_WEIGHT * integral.relative() +
         TURNING_WEIGHT * std::clamp(turning, -1.0, 1.0) + size;
}

double
turningOf(const IncompleteModel& model, const BoundaryLoop& loop)
{
  double lacking = 0.0;
  for (const pcl::index_t vertex : loop.vertices) {
    lacking += M_PI;
    for (const pcl::index_t* triangle = model.adjacency.begin(vertex);
         triangle != model.adjacency.end(vertex);
         ++triangle)
      lacking -= angleAt(model, *triangle, vertex);
  }
  return -lacking / (2.0 * M_PI);
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
collectEvidence(const IncompleteModel& model, const BoundaryLoops& loops)
{
  std::vector<AreaBounds> closing;
  closing.reserve(loops.size());
  for (const BoundaryLoop& loop : loops)
    closing.push_back(leastSurface(loop.curve));
  const std::vector<IslandLoops> islands = sumLoops(model, loops, closing);
  std::vector<LoopEvidence> all(loops.size());
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const IslandLoops& island = islands[loops[i].island];
    const double others = island.closing_area - closing[i].lower;
    all[i].integral = boundaryIntegral(loops[i].curve);
    all[i].turning = turningOf(model, loops[i]);
    all[i].area_ratio =
        areaRatio(model.islands[loops[i].island].area + others, closing[i]);
    all[i].has_twin = hasTwin(closing[i].lower, island);
  }
  return all;
}

} // namespace repair
} // namespace pcl
