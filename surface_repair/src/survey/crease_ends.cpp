// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: sharp edges of the model that run out at a boundary.

#include "survey/crease_ends.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "mesh/corners.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace pcl::repair {

namespace {

/** Least angle between the sides of a sharp edge, radians: more than a smooth surface
 * turns over an edge that samples it. */
constexpr double LEAST_TURN = 0.8;
/** Edges of a chain: fewer are roughness, more say nothing of its end. */
constexpr std::size_t FEWEST_EDGES = 3;
constexpr std::size_t MOST_EDGES = 8;
/** Least cosine between an edge of a chain and the next: chains may zigzag. */
constexpr double GOES_ON = 0.3;

/** Least cosine between the end of a chain and an edge of the boundary that it goes on
 * along: only one of its sides is there. */
constexpr double GOES_ALONG = 0.95;

/** An edge of the model that leaves a vertex, and the angle between its sides. */
struct Spoke {
  pcl::index_t to = pcl::UNAVAILABLE;
  double turn = 0.0;                         /**< radians, above 0: convex */
  Eigen::Vector3d sides = Direction::Zero(); /**< sum of their unit normals */
};

struct Chain {
  std::size_t vertex = 0; /**< of the loop */
  std::vector<pcl::index_t> vertices;
  double turn = 0.0;                         /**< mean */
  Eigen::Vector3d sides = Direction::Zero(); /**< sum */
};

class CreaseSearch {
public:
  CreaseSearch(const IncompleteModel& model, const BoundaryLoop& loop)
  : model_(model), loop_(loop)
  {}

  std::vector<Chain>
  chains() const
  {
    std::vector<Chain> found;
    for (std::size_t k = 0; k < loop_.vertices.size(); ++k)
      if (std::optional<Chain> chain = chainFrom(k))
        found.push_back(std::move(*chain));
    std::stable_sort(found.begin(), found.end(), [](const Chain& a, const Chain& b) {
      return std::abs(a.turn) > std::abs(b.turn);
    });
    return found;
  }

  CreaseEnd
  endOf(const Chain& chain) const;

private:
  const Position&
  at(pcl::index_t vertex) const
  {
    return model_.positions[static_cast<std::size_t>(vertex)];
  }

  Eigen::Vector3d
  normalOf(pcl::index_t triangle) const
  {
    return ccaa::unitNormal(ccaa::cornersOf(
        model_.triangles[static_cast<std::size_t>(triangle)], model_.positions));
  }

  /** The sharpest edge from a vertex of those that go on a chain that came from
   * another one; of a chain that begins: UNAVAILABLE, 0. */
  std::optional<Spoke>
  sharpest(pcl::index_t vertex, pcl::index_t from, double turn) const;
  std::optional<Chain>
  chainFrom(std::size_t k) const;
  void
  followBoundary(Chain& chain) const;

  const IncompleteModel& model_;
  const BoundaryLoop& loop_;
};

std::optional<Spoke>
CreaseSearch::sharpest(pcl::index_t vertex, pcl::index_t from, double turn) const
{
  std::optional<Spoke> best;
  for (const auto* t = model_.adjacency.begin(vertex);
       t != model_.adjacency.end(vertex);
       ++t) {
    const Triangle& triangle = model_.triangles[static_cast<std::size_t>(*t)];
    const auto c = static_cast<int>(
        std::find(triangle.begin(), triangle.end(), vertex) - triangle.begin());
    const pcl::index_t other = model_.adjacency.across(*t, c);
    Spoke spoke;
    spoke.to = triangle[static_cast<std::size_t>((c + 1) % 3)];
    if (other < 0 || spoke.to == from)
      continue;
    const Eigen::Vector3d way = (at(spoke.to) - at(vertex)).normalized();
    const Eigen::Vector3d left = normalOf(*t), right = normalOf(other);
    spoke.turn = std::atan2(left.cross(right).dot(way), left.dot(right));
    spoke.sides = left + right;
    if (std::abs(spoke.turn) < LEAST_TURN || spoke.turn * turn < 0.0)
      continue;
    if (from != pcl::UNAVAILABLE &&
        way.dot((at(vertex) - at(from)).normalized()) < GOES_ON)
      continue;
    if (!best || std::abs(spoke.turn) > std::abs(best->turn))
      best = spoke;
  }
  return best;
}

std::optional<Chain>
CreaseSearch::chainFrom(std::size_t k) const
{
  Chain chain;
  chain.vertex = k;
  chain.vertices.push_back(loop_.vertices[k]);
  pcl::index_t from = pcl::UNAVAILABLE;
  while (chain.vertices.size() <= MOST_EDGES) {
    const auto spoke = sharpest(chain.vertices.back(), from, chain.turn);
    if (!spoke || model_.adjacency.fan(spoke->to) != ccaa::Fan::CLOSED ||
        std::count(chain.vertices.begin(), chain.vertices.end(), spoke->to) > 0)
      break;
    from = chain.vertices.back();
    chain.vertices.push_back(spoke->to);
    chain.turn += spoke->turn;
    chain.sides += spoke->sides;
  }
  if (chain.vertices.size() <= FEWEST_EDGES)
    return std::nullopt;
  chain.turn /= static_cast<double>(chain.vertices.size() - 1);
  followBoundary(chain);
  return chain;
}

void
CreaseSearch::followBoundary(Chain& chain) const
{
  const std::size_t count = loop_.vertices.size();
  for (const std::size_t step : {std::size_t{1}, count - 1})
    while (chain.vertices.size() <= 2 * MOST_EDGES) {
      const std::size_t next = (chain.vertex + step) % count;
      const Position& end = at(chain.vertices[0]);
      const Eigen::Vector3d way = (at(loop_.vertices[next]) - end).normalized();
      if (way.dot((end - at(chain.vertices[1])).normalized()) < GOES_ALONG)
        break;
      chain.vertex = next;
      chain.vertices.insert(chain.vertices.begin(), loop_.vertices[next]);
    }
}

/** The direction of a parabola by least squares, in arc length from the end. */
CreaseEnd
CreaseSearch::endOf(const Chain& chain) const
{
  CreaseEnd end;
  end.vertex = chain.vertex;
  end.is_convex = chain.turn > 0.0;
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
  Eigen::Matrix<double, 2, 3> moments = Eigen::Matrix<double, 2, 3>::Zero();
  double arc = 0.0;
  for (std::size_t i = 1; i < chain.vertices.size(); ++i) {
    arc += (at(chain.vertices[i]) - at(chain.vertices[i - 1])).norm();
    const Eigen::Vector2d powers(arc, arc * arc);
    squares += powers * powers.transpose();
    moments +=
        powers * (at(chain.vertices[i]) - at(chain.vertices.front())).transpose();
  }
  end.edge = arc / static_cast<double>(chain.vertices.size() - 1);
  const Eigen::Matrix<double, 2, 3> parabola = squares.ldlt().solve(moments);
  end.along = -parabola.row(0).transpose().normalized();
  end.normal = (chain.sides - chain.sides.dot(end.along) * end.along).normalized();
  return end;
}

} // namespace

std::vector<CreaseEnd>
creaseEnds(const IncompleteModel& model, const BoundaryLoop& loop)
{
  const CreaseSearch search(model, loop);
  std::set<pcl::index_t> taken;
  std::vector<CreaseEnd> ends;
  for (const Chain& chain : search.chains()) {
    if (std::any_of(chain.vertices.begin(),
                    chain.vertices.end(),
                    [&](pcl::index_t vertex) { return taken.count(vertex) > 0; }))
      continue;
    taken.insert(chain.vertices.begin(), chain.vertices.end());
    const CreaseEnd end = search.endOf(chain);
    if (end.along.allFinite() && end.normal.norm() > 0.5)
      ends.push_back(end);
  }
  return ends;
}

} // namespace pcl::repair
