// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: finds the wrong triangles that make a region one-sided.
#include "umbrella/twist_cut.h"

#include <Eigen/Geometry>

#include "mesh/label_votes.h"

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

/** What is known of the edge at each corner of a triangle, two bits a corner. Edges are
 * noted at their triangle of higher index. */
constexpr unsigned int SMOOTH = 1;
constexpr unsigned int WOUND_ALIKE = 2;

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
  : adjacency_(adjacency)
  , limits_(limits)
  , context_(context)
  , meter_(triangles, adjacency, positions, context)
  , edges_(triangles.size())
  {}

  std::vector<index_t>
  find()
  {
    measureEdges();
    if (context_.cancelled())
      return {};
    if (!joinSmoothEdges())
      return {};
    joinBentEdges();
    if (context_.cancelled())
      return {};
    findWrong();
    return wrong_.empty() ? wrong_ : affordable();
  }

private:
  std::size_t
  size() const
  {
    return edges_.size();
  }

  /** The part that takes the time, on all threads. */
  void
  measureEdges()
  {
    const double smooth = std::cos(limits_.smooth_angle);
    std::vector<std::vector<BentEdge>> bent(context_.blockCount(size()));
    forEachBlock(
        size(), context_, [&](std::size_t block, std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i)
            edges_[i] = edgesOf(static_cast<index_t>(i), smooth, bent[block]);
        });
    for (const std::vector<BentEdge>& part : bent)
      bent_.insert(bent_.end(), part.begin(), part.end());
    spend(context_.control, size());
    std::stable_sort(
        bent_.begin(), bent_.end(), [](const BentEdge& e, const BentEdge& f) {
          return e.cosine > f.cosine;
        });
  }

  std::uint8_t
  edgesOf(index_t triangle, double smooth, std::vector<BentEdge>& bent) const
  {
    unsigned int bits = 0;
    for (int corner = 0; corner < 3; ++corner) {
      const index_t other = adjacency_.across(triangle, corner);
      if (other < 0 || other > triangle)
        continue;
      const BentEdge edge = meter_.edge(triangle, corner, other);
      if (edge.cosine > smooth)
        bits |= (SMOOTH | (edge.wound_alike ? WOUND_ALIKE : 0u)) << 2 * corner;
      else
        bent.push_back(edge);
    }
    return static_cast<std::uint8_t>(bits);
  }

  /** One triangle after the other: each takes the label of a neighbor before it.
   * \return false when cancelled */
  bool
  joinSmoothEdges()
  {
    for (std::size_t i = 0; i < size(); ++i) {
      if (i % BLOCK_SIZE == 0 && context_.control != nullptr &&
          !context_.control->report(context_.stage, double(i) / double(size())))
        return false;
      const auto triangle = static_cast<index_t>(i);
      sets_.add();
      for (int corner = 0; corner < 3; ++corner) {
        const unsigned int bits = edges_[i] >> 2 * corner & 3u;
        if ((bits & SMOOTH) != 0 && !join(adjacency_.across(triangle, corner),
                                          triangle,
                                          (bits & WOUND_ALIKE) != 0))
          truly_one_sided_.push_back(triangle);
      }
    }
    return true;
  }

  /** An even one tells more. */
  void
  joinBentEdges()
  {
    std::vector<LabelVote> votes;
    votes.reserve(bent_.size());
    for (const BentEdge& edge : bent_) {
      const double evenness = (1.0 + edge.cosine) * (1.0 + edge.cosine);
      votes.push_back(
          {{edge.lower, edge.higher}, edge.wound_alike ? evenness : -evenness});
    }
    joinClearest(std::move(votes), sets_, context_.control);
  }

  /** Of each bent edge whose triangles disagree now, unless one of them goes already.
   */
  void
  findWrong()
  {
    spend(context_.control, size());
    std::vector<char> is_wrong(size(), 0);
    for (const BentEdge& edge : bent_) {
      if (is_wrong[static_cast<std::size_t>(edge.lower)] != 0 ||
          is_wrong[static_cast<std::size_t>(edge.higher)] != 0 ||
          join(edge.lower, edge.higher, edge.wound_alike))
        continue;
      wrong_.push_back(meter_.evenness(edge.lower) < meter_.evenness(edge.higher)
                           ? edge.lower
                           : edge.higher);
      is_wrong[static_cast<std::size_t>(wrong_.back())] = 1;
    }
  }

  /** \return false when the winding that the edge wants contradicts the others' */
  bool
  join(index_t lower, index_t higher, bool wound_alike)
  {
    return sets_.join(2 * lower, 2 * higher + (wound_alike ? 0 : 1));
  }

  /** First triangle of the region of a triangle. */
  std::size_t
  region(index_t triangle)
  {
    return static_cast<std::size_t>(sets_.find(2 * triangle) >> 1);
  }

  /** The wrong triangles of regions that are worth cutting. */
  std::vector<index_t>
  affordable()
  {
    struct Balance {
      double triangles = 0;
      double wrong = 0;
    };
    spend(context_.control, size());
    std::vector<Balance> balance(size());
    for (std::size_t i = 0; i < size(); ++i)
      ++balance[region(static_cast<index_t>(i))].triangles;
    for (const index_t triangle : wrong_)
      ++balance[region(triangle)].wrong;
    for (const index_t triangle : truly_one_sided_)
      balance[region(triangle)].triangles = 0;
    std::vector<index_t> kept;
    for (const index_t triangle : wrong_) {
      const Balance& all = balance[region(triangle)];
      if (all.wrong <= limits_.largest_share * all.triangles)
        kept.push_back(triangle);
    }
    return kept;
  }

  const TriangleAdjacency& adjacency_;
  const TwistLimits& limits_;
  const LoopContext& context_;
  const BendMeter meter_;
  std::vector<std::uint8_t> edges_; /**< SMOOTH and WOUND_ALIKE, two bits a corner */
  std::vector<BentEdge> bent_;
  LabelSets sets_; /**< a label for each triangle */
  std::vector<index_t> truly_one_sided_;
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
  return TwistSearch(triangles, adjacency, positions, limits, context).find();
}

} // namespace pcl::ccaa
