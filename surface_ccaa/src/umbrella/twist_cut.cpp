// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: finds the wrong triangles that make a region one-sided.
#include "umbrella/twist_cut.h"

#include <Eigen/Geometry>

#include "mesh/label_votes.h"
#include "mesh/winding.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pcl::ccaa {
namespace {

/** An edge between two triangles whose normals differ a lot. */
struct BentEdge {
  index_t lower;  /**< triangle of lower index */
  index_t higher; /**< the other triangle */
  double cosine;  /**< of the angle between their normals, wound alike */
  bool wound_alike;
};

/** The mesh with a normal for each triangle. */
class BendMeter {
public:
  BendMeter(const Triangles& triangles,
            const TriangleAdjacency& adjacency,
            const Positions& positions,
            const LoopContext& context)
  : triangles_(triangles), adjacency_(adjacency), normals_(triangles.size())
  {
    forEachBlock(triangles.size(),
                 context,
                 [&](std::size_t, std::size_t begin, std::size_t end) {
                   for (std::size_t i = begin; i < end; ++i)
                     normals_[i] = normal(triangles[i], positions);
                 });
  }

  /** The edge at a corner of a triangle to a neighbor. */
  BentEdge
  edge(index_t triangle, int corner, index_t other) const
  {
    const Triangle& mine = triangles_[static_cast<std::size_t>(triangle)];
    const Triangle& theirs = triangles_[static_cast<std::size_t>(other)];
    const index_t from = mine[static_cast<std::size_t>(corner)];
    const index_t to = mine[static_cast<std::size_t>((corner + 1) % 3)];
    bool same_direction = false;
    for (std::size_t c = 0; c < 3; ++c)
      same_direction |= theirs[c] == from && theirs[c == 2 ? 0 : c + 1] == to;
    const double cosine = normals_[static_cast<std::size_t>(triangle)].dot(
        normals_[static_cast<std::size_t>(other)]);
    return {other, triangle, same_direction ? -cosine : cosine, !same_direction};
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
        sum += edge(triangle, corner, other).cosine;
    }
    return sum;
  }

private:
  /** Unit normal; zero for a triangle without area, whose edges all count as bent. */
  static Eigen::Vector3f
  normal(const Triangle& triangle, const Positions& positions)
  {
    const Position& a = positions[static_cast<std::size_t>(triangle[0])];
    const Position& b = positions[static_cast<std::size_t>(triangle[1])];
    const Position& c = positions[static_cast<std::size_t>(triangle[2])];
    const Position across = (b - a).cross(c - a);
    const double length = across.norm();
    return length > 0 ? Eigen::Vector3f((across / length).cast<float>())
                      : Eigen::Vector3f(Eigen::Vector3f::Zero());
  }

  const Triangles& triangles_;
  const TriangleAdjacency& adjacency_;
  std::vector<Eigen::Vector3f> normals_;
};

/** One search for twists. */
class TwistSearch {
public:
  TwistSearch(const Triangles& triangles,
              const TriangleAdjacency& adjacency,
              const Positions& positions,
              const TwistLimits& limits,
              const LoopContext& context)
  : triangles_(triangles)
  , adjacency_(adjacency)
  , limits_(limits)
  , context_(context)
  , meter_(triangles, adjacency, positions, context)
  , is_bent_(triangles.size())
  {}

  std::vector<index_t>
  find(RunControl& control)
  {
    measureEdges();
    if (context_.cancelled() ||
        !smooth_.find(triangles_, adjacency_, context_.threads, control, is_bent_))
      return {};
    joinBentEdges();
    if (context_.cancelled())
      return {};
    findWrong();
    return wrong_.empty() ? wrong_ : affordable();
  }

private:
  void
  measureEdges()
  {
    const double smooth = std::cos(limits_.smooth_angle);
    std::vector<std::vector<BentEdge>> bent(context_.blockCount(is_bent_.size()));
    forEachBlock(is_bent_.size(),
                 context_,
                 [&](std::size_t block, std::size_t begin, std::size_t end) {
                   for (std::size_t i = begin; i < end; ++i)
                     is_bent_[i] =
                         bentEdgesOf(static_cast<index_t>(i), smooth, bent[block]);
                 });
    bent_ = joinBlocks(bent);
    spend(context_.control, is_bent_.size());
    std::stable_sort(
        bent_.begin(), bent_.end(), [](const BentEdge& e, const BentEdge& f) {
          return e.cosine > f.cosine;
        });
  }

  /** \return see CutEdges */
  std::uint8_t
  bentEdgesOf(index_t triangle, double smooth, std::vector<BentEdge>& bent) const
  {
    unsigned int bits = 0;
    for (int corner = 0; corner < 3; ++corner) {
      const index_t other = adjacency_.across(triangle, corner);
      if (other < 0 || other > triangle)
        continue;
      const BentEdge edge = meter_.edge(triangle, corner, other);
      if (edge.cosine > smooth)
        continue;
      bits |= 1u << corner;
      bent.push_back(edge);
    }
    return static_cast<std::uint8_t>(bits);
  }

  /** An even one tells more. */
  void
  joinBentEdges()
  {
    for (std::size_t i = 0; i < smooth_.components().size(); ++i)
      sets_.add();
    std::vector<LabelVote> votes;
    votes.reserve(bent_.size());
    for (const BentEdge& edge : bent_) {
      const index_t lower = smooth_.state(edge.lower);
      const index_t higher = smooth_.state(edge.higher);
      const double evenness = (1.0 + edge.cosine) * (1.0 + edge.cosine);
      votes.push_back(
          {{lower / 2, higher / 2},
           edge.wound_alike == ((lower ^ higher) % 2 == 0) ? evenness : -evenness});
    }
    joinClearest(std::move(votes), sets_, context_.control);
  }

  /** Of each bent edge whose triangles disagree now, unless one of them goes already.
   */
  void
  findWrong()
  {
    spend(context_.control, is_bent_.size());
    std::vector<char> is_wrong(is_bent_.size(), 0);
    for (const BentEdge& edge : bent_) {
      if (is_wrong[static_cast<std::size_t>(edge.lower)] != 0 ||
          is_wrong[static_cast<std::size_t>(edge.higher)] != 0 ||
          sets_.join(smooth_.state(edge.lower),
                     smooth_.state(edge.higher) ^ (edge.wound_alike ? 0 : 1)))
        continue;
      wrong_.push_back(meter_.evenness(edge.lower) < meter_.evenness(edge.higher)
                           ? edge.lower
                           : edge.higher);
      is_wrong[static_cast<std::size_t>(wrong_.back())] = 1;
    }
  }

  /** The wrong triangles of regions that are worth cutting. */
  std::vector<index_t>
  affordable()
  {
    struct Balance {
      double triangles = 0;
      double wrong = 0;
      bool is_truly_one_sided = false;
    };
    const auto& parts = smooth_.components();
    std::vector<Balance> balance(parts.size());
    const auto of = [&](index_t state) -> Balance& {
      return balance[static_cast<std::size_t>(sets_.find(state) >> 1)];
    };
    for (std::size_t i = 0; i < parts.size(); ++i) {
      Balance& all = of(2 * static_cast<index_t>(i));
      all.triangles += static_cast<double>(parts[i].triangles);
      all.is_truly_one_sided = all.is_truly_one_sided || parts[i].one_sided;
    }
    for (const index_t triangle : wrong_)
      ++of(smooth_.state(triangle)).wrong;
    std::vector<index_t> kept;
    for (const index_t triangle : wrong_) {
      const Balance& all = of(smooth_.state(triangle));
      if (!all.is_truly_one_sided && all.wrong <= limits_.largest_share * all.triangles)
        kept.push_back(triangle);
    }
    return kept;
  }

  const Triangles& triangles_;
  const TriangleAdjacency& adjacency_;
  const TwistLimits& limits_;
  const LoopContext& context_;
  const BendMeter meter_;
  CutEdges is_bent_;
  std::vector<BentEdge> bent_;
  Winding smooth_; /**< over edges that are not bent */
  LabelSets sets_; /**< a label for each of its components */
  std::vector<index_t> wrong_;
};

} // namespace

std::vector<index_t>
findTwists(const Triangles& triangles,
           const TriangleAdjacency& adjacency,
           const Positions& positions,
           const TwistLimits& limits,
           const LoopContext& context)
{
  RunControl unasked({});
  return TwistSearch(triangles, adjacency, positions, limits, context)
      .find(context.control != nullptr ? *context.control : unasked);
}

} // namespace pcl::ccaa
