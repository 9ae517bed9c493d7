// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: whether a rim looks at the boundary of another island.
#include "boundary/facing_search.h"

#include "boundary/smooth_conormals.h"

#include <algorithm>
#include <cmath>

namespace pcl::repair {
namespace {

/** Points taken of one loop: of a triangle some on each edge, of a long loop a sample.
 */
constexpr std::size_t FEWEST_POINTS = 24;
constexpr std::size_t MOST_POINTS = 128;
constexpr std::size_t LEAF_POINTS = 4;
/** Half the opening of a view. Wide, because around the tip of a limb the other side of
 * a gap lies far off the conormal. */
constexpr double VIEW_ANGLE = M_PI / 3.0;
/** Share of the own loop's length below which another loop is a fragment. */
constexpr double FRAGMENT_SHARE = 0.1;

} // namespace

FacingSearch::FacingSearch(const BoundaryLoops& loops)
{
  for (const BoundaryLoop& loop : loops) {
    first_of_loop_.push_back(by_loop_.size());
    addPoints(loop);
  }
  first_of_loop_.push_back(by_loop_.size());
  points_ = by_loop_;
  if (!points_.empty())
    build(0, points_.size());
}

void
FacingSearch::addPoints(const BoundaryLoop& loop)
{
  const BoundaryCurve& curve = loop.curve;
  const Directions conormals = smoothConormals(curve, 0.0);
  const std::size_t count = std::clamp(curve.size(), FEWEST_POINTS, MOST_POINTS);
  for (std::size_t i = 0; i < count; ++i) {
    const double place =
        static_cast<double>(i * curve.size()) / static_cast<double>(count);
    const auto k = static_cast<std::size_t>(place);
    const double share = place - static_cast<double>(k);
    const std::size_t next = curve.next(k);
    by_loop_.push_back(
        {curve.points[k] + share * curve.edge(k),
         (conormals[k] + share * (conormals[next] - conormals[k])).normalized(),
         loop.island,
         loop.length});
  }
}

std::size_t
FacingSearch::build(std::size_t begin, std::size_t end)
{
  const std::size_t index = nodes_.size();
  nodes_.emplace_back();
  nodes_[index].begin = begin;
  nodes_[index].end = end;
  measure(nodes_[index]);
  if (end - begin > LEAF_POINTS) {
    Eigen::AlignedBox3d box;
    for (std::size_t i = begin; i < end; ++i)
      box.extend(points_[i].position);
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::size_t place) {
      return points_.begin() + static_cast<std::ptrdiff_t>(place);
    };
    std::nth_element(at(begin),
                     at(middle),
                     at(end),
                     [axis](const BoundaryPoint& a, const BoundaryPoint& b) {
                       return a.position[axis] < b.position[axis];
                     });
    build(begin, middle);
    const std::size_t right = build(middle, end);
    nodes_[index].right = right;
  }
  return index;
}

void
FacingSearch::measure(Node& node) const
{
  Eigen::AlignedBox3d box;
  node.island = points_[node.begin].island;
  for (std::size_t i = node.begin; i < node.end; ++i) {
    box.extend(points_[i].position);
    node.longest = std::max(node.longest, points_[i].loop_length);
    if (points_[i].island != node.island)
      node.island = NONE;
  }
  node.center = box.center();
  node.radius = 0.5 * box.diagonal().norm();
}

double
FacingSearch::facedShare(std::size_t loop) const
{
  const std::size_t begin = first_of_loop_[loop];
  const std::size_t end = first_of_loop_[loop + 1];
  std::size_t seeing = 0;
  for (std::size_t i = begin; i < end; ++i)
    seeing += seesAnother(by_loop_[i]) ? 1 : 0;
  return end == begin ? 0.0
                      : static_cast<double>(seeing) / static_cast<double>(end - begin);
}

bool
FacingSearch::seesAnother(const BoundaryPoint& from) const
{
  const double cosine = std::cos(VIEW_ANGLE);
  const auto is_seen = [&](const BoundaryPoint& other) {
    const Position view = other.position - from.position;
    return other.island != from.island &&
           other.loop_length >= FRAGMENT_SHARE * from.loop_length &&
           from.conormal.dot(view) >= cosine * view.norm() &&
           other.conormal.dot(view) < 0.0;
  };
  std::vector<std::size_t> stack{0};
  while (!stack.empty()) {
    const Node& node = nodes_[stack.back()];
    const std::size_t left = stack.back() + 1;
    stack.pop_back();
    if (!mayHold(node, from))
      continue;
    if (node.right != 0) {
      stack.push_back(node.right);
      stack.push_back(left);
    }
    else if (std::any_of(points_.begin() + static_cast<std::ptrdiff_t>(node.begin),
                         points_.begin() + static_cast<std::ptrdiff_t>(node.end),
                         is_seen))
      return true;
  }
  return false;
}

/** \brief Whether the ball around a node meets the view. */
bool
FacingSearch::mayHold(const Node& node, const BoundaryPoint& from) const
{
  if (node.island == from.island || node.longest < FRAGMENT_SHARE * from.loop_length)
    return false;
  const Position view = node.center - from.position;
  const double distance = view.norm();
  if (distance <= node.radius)
    return true;
  const double ball = std::asin(node.radius / distance); // half its angle
  const double off =
      std::acos(std::clamp(from.conormal.dot(view) / distance, -1.0, 1.0));
  return off <= VIEW_ANGLE + ball + 1e-9;
}

} // namespace pcl::repair
