// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: flips until the triangles of a patch are Delaunay-like.

#include "fairing/edge_flips.h"

#include <Eigen/Geometry>

#include "fairing/vertex_spacing.h"
#include "mesh/corners.h"

#include <algorithm>
#include <deque>

namespace pcl::repair {

namespace {

constexpr double DELAUNAY_SLACK = 1e-6; /**< in cotangents: cocircular corners stay */
constexpr double LARGEST_FOLD = 0.5;    /**< cosine between the normals of a new pair */
/** On average, beyond which flips go round in a circle. */
constexpr std::size_t FLIPS_AN_EDGE = 10;
/** Operations for an edge that is looked at, and edges after which they are told. */
constexpr std::size_t EDGE_WORK = 8;
constexpr std::size_t EDGES_AT_ONCE = 4096;

double
cotangentAt(const Position& apex, const Position& a, const Position& b)
{
  const Eigen::Vector3d to_a = a - apex, to_b = b - apex;
  const double area = to_a.cross(to_b).norm();
  const double dot = to_a.dot(to_b);
  const double least = 1e-12 * (to_a.squaredNorm() + to_b.squaredNorm());
  return dot / std::max(area, least);
}

/** The four corners around an edge a-b. */
struct Corners4 {
  Position a, b, c, d;

  bool
  wantsFlip() const
  {
    return cotangentAt(c, a, b) + cotangentAt(d, a, b) < -DELAUNAY_SLACK;
  }

  bool
  areInOnePlane() const
  {
    return ccaa::unitNormal({a, b, c}).dot(ccaa::unitNormal({b, a, d})) > ONE_PLANE;
  }

  /** The new pair faces the way the old one did, and is not folded more sharply. */
  bool
  staysUnfolded() const
  {
    const Eigen::Vector3d before_c = ccaa::areaNormal({a, b, c});
    const Eigen::Vector3d before_d = ccaa::areaNormal({b, a, d});
    const Eigen::Vector3d mean = (before_c + before_d).normalized();
    const Eigen::Vector3d after_a = ccaa::unitNormal({a, d, c});
    const Eigen::Vector3d after_b = ccaa::unitNormal({d, b, c});
    const double fold = before_c.normalized().dot(before_d.normalized());
    return after_a.dot(after_b) >= std::min(fold, LARGEST_FOLD) &&
           after_a.dot(mean) > 0.1 && after_b.dot(mean) > 0.1;
  }
};

class Flipping {
public:
  Flipping(const Patch& patch,
           PatchEdges& edges,
           bool keeps_shape,
           ccaa::RunControl* control)
  : patch_(patch)
  , edges_(edges)
  , keeps_shape_(keeps_shape)
  , control_(control)
  , queued_(edges.count(), 1)
  {
    for (std::size_t side = 0; side < edges.count(); ++side)
      queue_.push_back(side);
  }

  void
  run()
  {
    std::size_t left = FLIPS_AN_EDGE * edges_.count();
    for (std::size_t asked = 1; !queue_.empty() && left > 0; ++asked) {
      if (asked % EDGES_AT_ONCE == 0 &&
          !ccaa::spend(control_, EDGES_AT_ONCE * EDGE_WORK))
        return;
      const std::size_t side = queue_.front();
      queue_.pop_front();
      queued_[side] = 0;
      if (!edges_.speaks(side) || !mayFlip(side))
        continue;
      const std::size_t other = edges_.across(side);
      edges_.flip(side);
      --left;
      for (const std::size_t triangle : {side / 3, other / 3})
        for (std::size_t c = 0; c < 3; ++c)
          push(3 * triangle + c);
    }
  }

private:
  bool
  mayFlip(std::size_t side) const
  {
    const PatchEdges::Pair pair = edges_.pairAt(side);
    const Corners4 corners{patch_.positions[pair.a],
                           patch_.positions[pair.b],
                           patch_.positions[pair.c],
                           patch_.positions[pair.d]};
    return pair.c != pair.d && !patch_.isCrease(pair.a, pair.b) &&
           corners.wantsFlip() && corners.staysUnfolded() &&
           (!keeps_shape_ || corners.areInOnePlane()) &&
           !edges_.areJoined(pair.c, pair.d) &&
           !edges_.areJoinedInModel(pair.c, pair.d);
  }

  void
  push(std::size_t side)
  {
    if (!edges_.isInner(side))
      return;
    const std::size_t speaker = std::min(side, edges_.across(side));
    if (queued_[speaker] != 0)
      return;
    queued_[speaker] = 1;
    queue_.push_back(speaker);
  }

  const Patch& patch_;
  PatchEdges& edges_;
  bool keeps_shape_;
  ccaa::RunControl* control_;
  std::vector<char> queued_;
  std::deque<std::size_t> queue_;
};

} // namespace

void
flipToDelaunay(const Patch& patch,
               PatchEdges& edges,
               bool keeps_shape,
               ccaa::RunControl* control)
{
  Flipping(patch, edges, keeps_shape, control).run();
}

} // namespace pcl::repair
