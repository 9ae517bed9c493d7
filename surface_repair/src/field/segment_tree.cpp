// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which of many boxes a segment passes.
#include "field/segment_tree.h"

#include "mesh/block_loop.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl {
namespace repair {
namespace {

/** \brief By how much boxes are too large, in the frame, so that no rounding of single
 * precision loses one. */
constexpr float MARGIN = 2e-6f;

/** \brief A place that no segment comes to. */
constexpr float NOWHERE = 1e18f;

/** \brief Steepest 1 / component of a segment: a component of nothing is this small. */
constexpr double MOST_INVERSE = 1e12;

/** \brief Parts of a tree that each thread arranges, so that all have enough. */
constexpr std::size_t STRETCHES_A_THREAD = 4;

using Place = std::vector<pcl::index_t>::iterator;

/** \brief The axis along which the centres of some boxes spread most. */
int
widestAxis(const std::vector<ccaa::Box>& boxes, Place begin, Place end)
{
  ccaa::Box spread;
  for (Place place = begin; place != end; ++place)
    spread.extend(boxes[static_cast<std::size_t>(*place)].center());
  int axis = 0;
  spread.sizes().maxCoeff(&axis);
  return axis;
}

/** \brief Some of the boxes, in the order of the tree. */
struct Stretch {
  Place begin, end;
};

/** \brief Halve a run along the widest axis, at a multiple of the largest run of runs
 * of `fan_out`. Ties by index. \return the middle; the end where nothing is to halve */
Place
halve(const std::vector<ccaa::Box>& boxes, const Stretch& all, std::size_t fan_out)
{
  const auto [begin, end] = all;
  const auto count = static_cast<std::size_t>(end - begin);
  if (count <= fan_out)
    return end;
  std::size_t run = fan_out;
  while (run * fan_out < count)
    run *= fan_out;
  const std::size_t runs = (count + run - 1) / run;
  const Place middle = begin + static_cast<std::ptrdiff_t>((runs / 2) * run);
  const int axis = widestAxis(boxes, begin, end);
  std::nth_element(begin, middle, end, [&](pcl::index_t i, pcl::index_t j) {
    const ccaa::Box& first = boxes[static_cast<std::size_t>(i)];
    const ccaa::Box& second = boxes[static_cast<std::size_t>(j)];
    const double a = first.min()[axis] + first.max()[axis];
    const double b = second.min()[axis] + second.max()[axis];
    return a < b || (a == b && i < j);
  });
  return middle;
}

/** \brief Order boxes so that each run of `fan_out`, and each run of as many runs and
 * so on, lies close together. Log-linear. */
void
arrange(const std::vector<ccaa::Box>& boxes, const Stretch& all, std::size_t fan_out)
{
  const Place middle = halve(boxes, all, fan_out);
  if (middle == all.end)
    return;
  arrange(boxes, {all.begin, middle}, fan_out);
  arrange(boxes, {middle, all.end}, fan_out);
}

/** \brief The same, with halves side by side once there are some. */
void
arrange(const std::vector<ccaa::Box>& boxes,
        const Stretch& all,
        std::size_t fan_out,
        int threads)
{
  const ccaa::LoopContext one_by_one{threads, nullptr, "", 1};
  std::vector<Stretch> stretches{all};
  while (threads > 1 &&
         stretches.size() < STRETCHES_A_THREAD * static_cast<std::size_t>(threads)) {
    std::vector<Place> middles(stretches.size());
    ccaa::forEachBlock(
        stretches.size(), one_by_one, [&](std::size_t i, std::size_t, std::size_t) {
          middles[i] = halve(boxes, stretches[i], fan_out);
        });
    std::vector<Stretch> halves;
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      halves.push_back({stretches[i].begin, middles[i]});
      halves.push_back({middles[i], stretches[i].end});
    }
    stretches = std::move(halves);
  }
  ccaa::forEachBlock(
      stretches.size(), one_by_one, [&](std::size_t i, std::size_t, std::size_t) {
        arrange(boxes, stretches[i], fan_out);
      });
}

} // namespace

void
SegmentTree::Node::set(std::size_t child, const ccaa::Box& box)
{
  for (int k = 0; k < 3; ++k) {
    bounds[0][k][child] = static_cast<float>(box.min()[k]) - MARGIN;
    bounds[1][k][child] = static_cast<float>(box.max()[k]) + MARGIN;
  }
}

ccaa::Box
SegmentTree::Node::box() const
{
  const auto corner = [this](std::size_t side, std::size_t i) {
    return ccaa::Position(bounds[side][0][i], bounds[side][1][i], bounds[side][2][i]);
  };
  ccaa::Box box;
  for (std::size_t i = 0; i < FAN_OUT; ++i)
    if (bounds[0][0][i] < NOWHERE) {
      box.extend(corner(0, i));
      box.extend(corner(1, i));
    }
  return box;
}

SegmentTree::SegmentTree(const std::vector<ccaa::Box>& boxes, int threads)
{
  ccaa::Box all;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    if (!boxes[i].isEmpty()) {
      order_.push_back(static_cast<pcl::index_t>(i));
      all.extend(boxes[i]);
    }
  if (order_.empty())
    return;
  origin_ = all.center();
  const double extent = all.sizes().maxCoeff();
  scale_ = extent > 0.0 ? 1.0 / extent : 1.0;
  arrange(boxes, {order_.begin(), order_.end()}, FAN_OUT, threads);
  std::vector<ccaa::Box> lower;
  for (const pcl::index_t i : order_) {
    const ccaa::Box& box = boxes[static_cast<std::size_t>(i)];
    lower.emplace_back((box.min() - origin_) * scale_, (box.max() - origin_) * scale_);
  }
  do
    lower = addLevel(lower);
  while (lower.size() > 1);
}

std::vector<ccaa::Box>
SegmentTree::addLevel(const std::vector<ccaa::Box>& lower)
{
  Node nothing;
  std::fill_n(&nothing.bounds[0][0][0], 2 * 3 * FAN_OUT, NOWHERE);
  levels_.emplace_back((lower.size() + FAN_OUT - 1) / FAN_OUT, nothing);
  std::vector<Node>& nodes = levels_.back();
  for (std::size_t i = 0; i < lower.size(); ++i)
    nodes[i / FAN_OUT].set(i % FAN_OUT, lower[i]);
  std::vector<ccaa::Box> bounds;
  for (const Node& node : nodes)
    bounds.push_back(node.box());
  return bounds;
}

SegmentTree::Ray
SegmentTree::rayFrom(const ccaa::Position& a, const ccaa::Position& b) const
{
  const ccaa::Position from = (a - origin_) * scale_;
  const Eigen::Vector3d way = (b - a) * scale_;
  Ray ray;
  for (int k = 0; k < 3; ++k) {
    const double inverse = std::clamp(1.0 / way[k], -MOST_INVERSE, MOST_INVERSE);
    std::fill_n(ray.from[k], WIDTH, static_cast<float>(from[k]));
    std::fill_n(ray.inverse[k], WIDTH, static_cast<float>(inverse));
    ray.entry[k] = inverse < 0.0 ? 1 : 0;
  }
  return ray;
}

} // namespace repair
} // namespace pcl
