// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a hole closed by the triangulation of least weight.

#include "filling/minimum_weight_filling.h"

#include "filling/coarse_to_fine.h"
#include "mesh/intersection.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <queue>
#include <set>
#include <utility>

namespace pcl::repair {

namespace {

/** In the order in which they are tried: lengths against folds. */
constexpr std::array<FillingWeights, 2> TRIED_WEIGHTS{{{0.3, 1.0}, {0.02, 1.0}}};
/** How often triangles that meet others are forbidden, for each of these. */
constexpr std::size_t MENDING_ROUNDS = 8;
/** Fillings, each without the edges that the ones before had twice. */
constexpr int REPEATING_ROUNDS = 8;

/** What stands in the way of triangles of one polygon: asked once a triangle, and only
 * from when some triangle that would be taken is not free. */
class Obstructions {
public:
  explicit Obstructions(const FillingTask& task) : task_(task) {}

  /** \brief \param[in] triangles of points that ascend */
  void
  forbid(const Triangles& triangles)
  {
    forbidden_.insert(triangles.begin(), triangles.end());
  }

  void
  allowAll()
  {
    forbidden_.clear();
  }

  bool
  any(const Triangles& triangles)
  {
    return std::any_of(triangles.begin(), triangles.end(), [&](Triangle t) {
      std::sort(t.begin(), t.end());
      return isObstructed(t);
    });
  }

  /** \brief To look out for, or not. */
  FillingLimits
  limits(bool all)
  {
    FillingLimits limits{task_.control, task_.joined, {}, {}};
    if (all && task_.crossed)
      limits.crossed = [this](std::size_t i, std::size_t j) { return isCrossed(i, j); };
    if (all)
      limits.obstructed = [this](std::size_t i, std::size_t m, std::size_t j) {
        const Triangle triangle{static_cast<pcl::index_t>(i),
                                static_cast<pcl::index_t>(m),
                                static_cast<pcl::index_t>(j)};
        return forbidden_.count(triangle) > 0 || isObstructed(triangle);
      };
    return limits;
  }

  /** \brief Whether no triangle with some edge of the polygon is free: then there is no
   * triangulation. */
  bool
  leaveAnEdgeBare()
  {
    const std::size_t n = task_.polygon.size();
    for (std::size_t i = 0; i < n; ++i)
      if (!hasTriangle(i))
        return true;
    return false;
  }

private:
  /** \param[in] from the first end of an edge; near points are asked for first */
  bool
  hasTriangle(std::size_t from)
  {
    const std::size_t n = task_.polygon.size();
    const std::size_t to = (from + 1) % n;
    for (std::size_t step = 0; step + 2 < n; ++step) {
      const std::size_t away = step / 2 + 1;
      const std::size_t apex = step % 2 == 0 ? (to + away) % n : (from + n - away) % n;
      Triangle triangle{static_cast<pcl::index_t>(from),
                        static_cast<pcl::index_t>(to),
                        static_cast<pcl::index_t>(apex)};
      std::sort(triangle.begin(), triangle.end());
      if (!isTaken(from, apex) && !isTaken(to, apex) && !isObstructed(triangle))
        return true;
    }
    return false;
  }

  bool
  isTaken(std::size_t a, std::size_t b) const
  {
    const Diagonal edge = std::minmax(a, b);
    return isDiagonal(edge, task_.polygon.size()) && task_.joined &&
           task_.joined(edge.first, edge.second);
  }

  bool
  isObstructed(const Triangle& ascending)
  {
    const auto known = obstructed_.find(ascending);
    if (known != obstructed_.end())
      return known->second;
    const Positions& points = task_.polygon.points;
    const Triangle wound{ascending[2], ascending[1], ascending[0]};
    const bool answer =
        task_.obstructed && task_.obstructed(ccaa::cornersOf(wound, points));
    obstructed_.emplace(ascending, answer);
    return answer;
  }

  bool
  isCrossed(std::size_t i, std::size_t j)
  {
    const auto [known, is_new] = crossed_.try_emplace({i, j}, false);
    if (is_new)
      known->second = task_.crossed(task_.polygon.points[i], task_.polygon.points[j]);
    return known->second;
  }

  const FillingTask& task_;
  std::set<Triangle> forbidden_;
  std::map<Triangle, bool> obstructed_;
  std::map<Diagonal, bool> crossed_;
};

/** Of triangles that meet each other, some without which no two do: always the one that
 * meets most others. Their points ascend. */
Triangles
culprits(const Triangles& triangles, const std::vector<ccaa::TrianglePair>& pairs)
{
  std::vector<std::vector<pcl::index_t>> met(triangles.size());
  for (const auto& [a, b] : pairs) {
    met[static_cast<std::size_t>(a)].push_back(b);
    met[static_cast<std::size_t>(b)].push_back(a);
  }
  std::vector<std::size_t> meetings;
  std::priority_queue<std::pair<std::size_t, pcl::index_t>> worst; // lowest of equals
  for (std::size_t t = 0; t < met.size(); ++t) {
    meetings.push_back(met[t].size());
    worst.emplace(met[t].size(), -static_cast<pcl::index_t>(t));
  }
  Triangles found;
  while (!worst.empty() && worst.top().first > 0) {
    const auto [count, turned] = worst.top();
    worst.pop();
    const auto triangle = static_cast<std::size_t>(-turned);
    if (count != meetings[triangle]) {
      worst.emplace(meetings[triangle], turned);
      continue;
    }
    found.push_back(triangles[triangle]);
    std::sort(found.back().begin(), found.back().end());
    meetings[triangle] = 0;
    for (const pcl::index_t other : met[triangle])
      if (meetings[static_cast<std::size_t>(other)] > 0)
        --meetings[static_cast<std::size_t>(other)];
  }
  return found;
}

/** The best triangulation so far. */
struct Best {
  Triangles triangles;
  std::size_t meetings = 0; /**< pairs of triangles that meet */
};

/** Triangulate, forbid what meets other triangles, and so on.
 * \return whether other weights could lead to something better */
bool
search(const FillingTask& task,
       const FillingWeights& weights,
       Obstructions& obstructions,
       Best& best)
{
  if (task.has_failed && obstructions.leaveAnEdgeBare())
    return false;
  obstructions.allowAll();
  bool obstructed = task.has_failed;
  Triangles forbidden; // in the round before
  FillingLimits limits;
  std::optional<TriangulationTable> table;
  const auto fill = [&] {
    limits = obstructions.limits(obstructed);
    table.emplace(triangulateCoarseToFine(task.polygon, weights, limits));
  };
  fill();
  for (std::size_t round = 0; round < MENDING_ROUNDS; ++round) {
    const Triangles& triangles = table->triangles();
    if (triangles.empty())
      return !forbidden.empty() || !areAllLookedAt(task.polygon.size());
    if (!obstructed && obstructions.any(triangles)) {
      if (obstructions.leaveAnEdgeBare())
        return false;
      obstructed = true;
      fill();
      continue;
    }
    ccaa::RunControl control(task.control);
    const auto pairs =
        ccaa::findSelfIntersections(triangles, task.polygon.points, 1, control).pairs;
    if (control.cancelled())
      return false;
    if (best.triangles.empty() || pairs.size() < best.meetings)
      best = {triangles, pairs.size()};
    if (pairs.empty())
      return false;
    forbidden = culprits(triangles, pairs);
    obstructions.forbid(forbidden);
    if (obstructed) {
      table->avoid(forbidden);
      continue;
    }
    obstructed = true;
    fill();
  }
  return true;
}

/** Of a polygon that passes vertices twice: diagonals that are the same edge as others
 * of the filling. */
std::vector<Diagonal>
repeatedDiagonals(const Triangles& triangles, const std::vector<pcl::index_t>& vertices)
{
  std::map<std::pair<pcl::index_t, pcl::index_t>, Diagonal> first_of;
  std::vector<Diagonal> repeated;
  for (const Triangle& triangle : triangles)
    for (std::size_t c = 0; c < 3; ++c) {
      const Diagonal places =
          std::minmax(static_cast<std::size_t>(triangle[c]),
                      static_cast<std::size_t>(triangle[(c + 1) % 3]));
      const auto edge = std::minmax(vertices[places.first], vertices[places.second]);
      const Diagonal first = first_of.emplace(edge, places).first->second;
      const bool is_inner = isDiagonal(places, vertices.size());
      if (first != places && (is_inner || isDiagonal(first, vertices.size())))
        repeated.push_back(is_inner ? places : first);
    }
  return repeated;
}

Filling
lightestFilling(const FillingTask& task, Obstructions& obstructions)
{
  Best best;
  for (const FillingWeights& weights : TRIED_WEIGHTS)
    if (!search(task, weights, obstructions, best))
      break;
  Filling filling;
  filling.triangles = std::move(best.triangles);
  if (filling.triangles.empty())
    filling.problem =
        "every triangulation runs through the surface or along edges that "
        "are taken";
  return filling;
}

/** With no edge twice: each time without those that came twice before. */
Filling
closeWithoutRepeating(FillingTask task)
{
  const std::vector<pcl::index_t> vertices = std::move(task.vertices);
  task.vertices.clear();
  std::set<Diagonal> repeated;
  task.joined = [&repeated, are_joined = task.joined](std::size_t a, std::size_t b) {
    return repeated.count(std::minmax(a, b)) > 0 || (are_joined && are_joined(a, b));
  };
  Obstructions obstructions(task);
  Filling filling;
  for (int round = 0; round < REPEATING_ROUNDS; ++round) {
    filling = lightestFilling(task, obstructions);
    const std::vector<Diagonal> more = repeatedDiagonals(filling.triangles, vertices);
    if (more.empty())
      break;
    repeated.insert(more.begin(), more.end());
  }
  return filling;
}

} // namespace

Filling
MinimumWeightFilling::close(const FillingTask& task) const
{
  if (task.polygon.size() < 3) {
    Filling filling;
    filling.problem = "the hole has fewer than three edges";
    return filling;
  }
  if (!task.vertices.empty())
    return closeWithoutRepeating(task);
  Obstructions obstructions(task);
  return lightestFilling(task, obstructions);
}

} // namespace pcl::repair
