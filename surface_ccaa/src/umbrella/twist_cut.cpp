// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: finds the wrong triangles that make a region one-sided.
#include <pcl/surface_ccaa/umbrella/twist_cut.h>

#include <Eigen/Geometry>

#include "../mesh/label_sets.h"

#include <algorithm>
#include <cmath>

namespace pcl {
namespace ccaa {
namespace {

/** An edge between two triangles of a one-sided region. */
struct InnerEdge {
  index_t lower;    /**< triangle of lower index */
  index_t higher;   /**< the other triangle */
  double cosine;    /**< of the angle between their normals, wound alike */
  bool wound_alike; /**< as the triangles are wound now */
};

/** The edges of one region, and where they say that it is turned over. */
class TwistFinder {
public:
  TwistFinder(const Triangles& triangles,
              const TriangleAdjacency& adjacency,
              const Positions& positions,
              const TwistLimits& limits)
  : triangles_(triangles)
  , adjacency_(adjacency)
  , positions_(positions)
  , limits_(limits)
  , number_(triangles.size(), UNKNOWN)
  {}

  /** \return the triangles to delete; none when the region is to stay as it is */
  std::vector<index_t>
  trianglesToDelete(index_t seed)
  {
    collect(seed);
    const double smooth = std::cos(limits_.smooth_angle);
    const auto bent = std::stable_partition(
        edges_.begin(), edges_.end(), [smooth](const InnerEdge& edge) {
          return edge.cosine > smooth;
        });
    for (auto edge = edges_.begin(); edge != bent; ++edge)
      if (!carryOver(*edge))
        return {};
    std::stable_sort(bent, edges_.end(), [](const InnerEdge& e, const InnerEdge& f) {
      return e.cosine > f.cosine;
    });
    std::vector<index_t> wrong;
    for (auto edge = bent; edge != edges_.end(); ++edge)
      if (!isWrong(edge->lower) && !isWrong(edge->higher) && !carryOver(*edge)) {
        wrong.push_back(evenness(edge->lower) < evenness(edge->higher) ? edge->lower
                                                                       : edge->higher);
        number_[static_cast<std::size_t>(wrong.back())] = WRONG;
      }
    const double allowed = limits_.largest_share * static_cast<double>(region_.size());
    return static_cast<double>(wrong.size()) <= allowed ? wrong
                                                        : std::vector<index_t>();
  }

private:
  static constexpr index_t UNKNOWN = -1;
  static constexpr index_t WRONG = -2;

  bool
  isWrong(index_t triangle) const
  {
    return number_[static_cast<std::size_t>(triangle)] == WRONG;
  }

  /** The region of the seed, in ascending order, and its inner edges. */
  void
  collect(index_t seed)
  {
    region_.assign(1, seed);
    number_[static_cast<std::size_t>(seed)] = 0;
    for (std::size_t next = 0; next < region_.size(); ++next)
      for (int corner = 0; corner < 3; ++corner) {
        const index_t other = adjacency_.across(region_[next], corner);
        if (other >= 0 && number_[static_cast<std::size_t>(other)] == UNKNOWN) {
          number_[static_cast<std::size_t>(other)] = 0;
          region_.push_back(other);
        }
      }
    std::sort(region_.begin(), region_.end());
    sets_ = {};
    edges_.clear();
    for (const index_t triangle : region_) {
      number_[static_cast<std::size_t>(triangle)] = sets_.add();
      for (int corner = 0; corner < 3; ++corner) {
        const index_t other = adjacency_.across(triangle, corner);
        if (other >= 0 && other < triangle)
          edges_.push_back(edgeBetween(other, triangle, corner));
      }
    }
  }

  InnerEdge
  edgeBetween(index_t lower, index_t higher, int corner) const
  {
    const Triangle& mine = triangles_[static_cast<std::size_t>(higher)];
    const Triangle& theirs = triangles_[static_cast<std::size_t>(lower)];
    const index_t from = mine[static_cast<std::size_t>(corner)];
    const index_t to = mine[static_cast<std::size_t>((corner + 1) % 3)];
    bool same_direction = false;
    for (std::size_t c = 0; c < 3; ++c)
      same_direction =
          same_direction || (theirs[c] == from && theirs[(c + 1) % 3] == to);
    const double cosine = normal(mine).dot(normal(theirs));
    return {lower, higher, same_direction ? -cosine : cosine, !same_direction};
  }

  /** Unit normal; zero for a triangle without area, whose edges all count as bent. */
  Position
  normal(const Triangle& triangle) const
  {
    const Position& a = positions_[static_cast<std::size_t>(triangle[0])];
    const Position& b = positions_[static_cast<std::size_t>(triangle[1])];
    const Position& c = positions_[static_cast<std::size_t>(triangle[2])];
    const Position across = (b - a).cross(c - a);
    const double length = across.norm();
    return length > 0 ? Position(across / length) : Position(Position::Zero());
  }

  /** How evenly a triangle continues its neighbors: the sum of the cosines over its
   * edges. */
  double
  evenness(index_t triangle) const
  {
    double sum = 0;
    for (int corner = 0; corner < 3; ++corner) {
      const index_t other = adjacency_.across(triangle, corner);
      if (other >= 0)
        sum += edgeBetween(other, triangle, corner).cosine;
    }
    return sum;
  }

  /** \return false when the winding that the edge wants contradicts the others' */
  bool
  carryOver(const InnerEdge& edge)
  {
    const index_t lower = number_[static_cast<std::size_t>(edge.lower)];
    const index_t higher = number_[static_cast<std::size_t>(edge.higher)];
    return sets_.join(lower, higher ^ (edge.wound_alike ? 0 : 1));
  }

  const Triangles& triangles_;
  const TriangleAdjacency& adjacency_;
  const Positions& positions_;
  const TwistLimits& limits_;
  std::vector<index_t> number_; /**< state of each triangle in sets_, or WRONG */
  std::vector<index_t> region_;
  std::vector<InnerEdge> edges_;
  LabelSets sets_;
};

} // namespace

std::size_t
cutTwists(const Triangles& triangles,
          const TriangleAdjacency& adjacency,
          const Positions& positions,
          const std::vector<OrientedComponent>& components,
          const TwistLimits& limits,
          AliveFlags& alive)
{
  TwistFinder finder(triangles, adjacency, positions, limits);
  std::size_t deleted = 0;
  for (const OrientedComponent& component : components) {
    if (component.rule != OutwardRule::ONE_SIDED)
      continue;
    for (const index_t triangle : finder.trianglesToDelete(component.first_triangle)) {
      alive[static_cast<std::size_t>(triangle)] = 0;
      ++deleted;
    }
  }
  return deleted;
}

} // namespace ccaa
} // namespace pcl
