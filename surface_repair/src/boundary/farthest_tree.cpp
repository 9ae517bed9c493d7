// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the most distant of many points, found through a tree.
#include "boundary/farthest_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace pcl::repair {
namespace {

/** Points of a leaf: they are looked at one by one. */
constexpr std::size_t MOST_LEAF_POINTS = 8;
/** Directions of less than this share of the box's length are rounding. */
constexpr double THIN = 1e-6;
/** Bounds are raised by more than rounding can have lowered them: a node may be opened
 * in vain, but no farther point is missed. */
constexpr double ROUNDING = 1.0 + 1e-12;

/** \brief Three perpendicular unit vectors, given two directions the points spread in.
 */
std::array<Direction, 3>
frameAlong(const Direction& first, const Direction& second)
{
  const double length = first.norm();
  if (!(length > 0.0))
    return {Direction::UnitX(), Direction::UnitY(), Direction::UnitZ()};
  const Direction along = first / length;
  Direction across = second - along * along.dot(second);
  const double width = across.norm();
  across = width > THIN * length ? Direction(across / width)
                                 : Direction(along.unitOrthogonal());
  return {along, across, along.cross(across)};
}

} // namespace

FarthestTree::FarthestTree(const Positions& points) : points_(points)
{
  order_.resize(points.size());
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  nodes_.reserve(points.size() / (MOST_LEAF_POINTS / 2) + 1);
  if (!points.empty())
    build(0, points.size());
}

std::size_t
FarthestTree::build(std::size_t begin, std::size_t end)
{
  const std::size_t index = nodes_.size();
  nodes_.emplace_back();
  nodes_[index].begin = begin;
  nodes_[index].end = end;
  fitBox(nodes_[index]);
  if (end - begin > MOST_LEAF_POINTS) {
    const std::size_t middle = split(nodes_[index]);
    build(begin, middle);
    const std::size_t right = build(middle, end);
    nodes_[index].right = right;
  }
  return index;
}

/** The first axis leads from the point farthest from the first one to the point
 * farthest from that; the second to the point farthest off that line. */
void
FarthestTree::fitBox(Node& node) const
{
  const auto first = order_.begin() + static_cast<std::ptrdiff_t>(node.begin);
  const auto last = order_.begin() + static_cast<std::ptrdiff_t>(node.end);
  node.lowest = *std::min_element(first, last);
  const auto farthest_by = [&](const auto& distance) -> const Position& {
    return points_[*std::max_element(first, last, [&](std::size_t a, std::size_t b) {
      return distance(points_[a]) < distance(points_[b]);
    })];
  };
  const Position& start = points_[*first];
  const Position& one =
      farthest_by([&](const Position& p) { return (p - start).squaredNorm(); });
  const Position& other =
      farthest_by([&](const Position& p) { return (p - one).squaredNorm(); });
  const Direction along = (other - one).normalized();
  const Position& side = farthest_by(
      [&](const Position& p) { return (p - one).cross(along).squaredNorm(); });
  node.axes = frameAlong(other - one, side - one);
  Eigen::Array3d low = Eigen::Array3d::Zero(); // of `one`
  Eigen::Array3d high = low;
  for (auto it = first; it != last; ++it) {
    const Position offset = points_[*it] - one;
    const Eigen::Array3d place(
        node.axes[0].dot(offset), node.axes[1].dot(offset), node.axes[2].dot(offset));
    low = low.min(place);
    high = high.max(place);
  }
  const Eigen::Array3d middle = 0.5 * (low + high);
  node.center = one;
  for (int i = 0; i < 3; ++i) {
    node.center += middle[i] * node.axes[static_cast<std::size_t>(i)];
    node.half_sizes[static_cast<std::size_t>(i)] = 0.5 * (high[i] - low[i]);
  }
}

/** In the middle of the points along the first axis; equal places by index. */
std::size_t
FarthestTree::split(const Node& node)
{
  const std::size_t middle = node.begin + (node.end - node.begin) / 2;
  const auto at = [&](std::size_t place) {
    return order_.begin() + static_cast<std::ptrdiff_t>(place);
  };
  const Direction axis = node.axes[0];
  std::nth_element(
      at(node.begin), at(middle), at(node.end), [&](std::size_t a, std::size_t b) {
        const double place_a = axis.dot(points_[a]);
        const double place_b = axis.dot(points_[b]);
        return place_a < place_b || (place_a == place_b && a < b);
      });
  return middle;
}

/** \brief No point of the node is farther than the farthest corner of its box. */
double
FarthestTree::boundOf(const Node& node, const Position& place)
{
  const Position offset = place - node.center;
  double sqr_sum = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double reach = std::abs(node.axes[i].dot(offset)) + node.half_sizes[i];
    sqr_sum += reach * reach;
  }
  return sqr_sum * ROUNDING;
}

std::size_t
FarthestTree::farthest(const Position& place, std::size_t guess) const
{
  Search search{place, guess, (points_[guess] - place).squaredNorm()};
  descend(0, boundOf(nodes_[0], place), search);
  return search.index;
}

/** The more promising child first. */
void
FarthestTree::descend(std::size_t index, double bound, Search& search) const
{
  const Node& node = nodes_[index];
  if (bound < search.sqr_distance ||
      (bound == search.sqr_distance && node.lowest > search.index))
    return;
  if (node.right == 0) {
    lookAtLeaf(node, search);
    return;
  }
  std::size_t near = index + 1;
  std::size_t far = node.right;
  double near_bound = boundOf(nodes_[near], search.place);
  double far_bound = boundOf(nodes_[far], search.place);
  if (near_bound > far_bound) {
    std::swap(near, far);
    std::swap(near_bound, far_bound);
  }
  descend(far, far_bound, search);
  descend(near, near_bound, search);
}

void
FarthestTree::lookAtLeaf(const Node& node, Search& search) const
{
  for (std::size_t i = node.begin; i < node.end; ++i) {
    const std::size_t index = order_[i];
    const double sqr_distance = (points_[index] - search.place).squaredNorm();
    if (sqr_distance > search.sqr_distance ||
        (sqr_distance == search.sqr_distance && index < search.index)) {
      search.index = index;
      search.sqr_distance = sqr_distance;
    }
  }
}

} // namespace pcl::repair
