// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which of many boxes meet a given box or segment.
#include "mesh/box_tree.h"

#include <cmath>
#include <cstdint>

namespace pcl::ccaa {
namespace {

/** By how much boxes are too large, in the frame, so that no rounding of single
 * precision loses one. */
constexpr float MARGIN = 2e-6f;

/** Queries that are further away, in the frame, count as this far: squares of distances
 * stay floats. */
constexpr double FARTHEST = 1e15;

/** The frame of what is smaller than this, in the units of the cloud, is no larger. */
constexpr double LEAST_EXTENT = 1e-150;

/** Steepest 1 / component of a segment: a component of nothing is this small. */
constexpr double MOST_INVERSE = 1e12;

/** Parts of an order that each thread arranges, so that all have enough. */
constexpr std::size_t STRETCHES_A_THREAD = 4;

/** Operations for a box that is put into one of two halves. */
constexpr std::uint64_t HALVING_WORK = 2;

/** Boxes to a node: halves are a multiple of it, and of its powers. */
constexpr std::size_t RUN = 8;

/** A box by its centre, twice as far from the origin. */
struct Middle {
  std::array<double, 3> place;
  pcl::index_t index;
};

using Place = std::vector<Middle>::iterator;

/** The axis along which some boxes spread most. */
std::size_t
widestAxis(Place begin, Place end)
{
  std::array<double, 3> low = begin->place, high = low;
  for (Place it = begin; it != end; ++it)
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], it->place[k]);
      high[k] = std::max(high[k], it->place[k]);
    }
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (high[k] - low[k] > high[axis] - low[axis])
      axis = k;
  return axis;
}

/** Some of the boxes, in the order of the tree. */
struct Stretch {
  Place begin, end;
};

/** Halve a stretch along the widest axis, at a multiple of the largest power of RUN.
 * Ties by index. \return the middle; the end where nothing is to halve */
Place
halve(const Stretch& all)
{
  const auto [begin, end] = all;
  const auto count = static_cast<std::size_t>(end - begin);
  if (count <= RUN)
    return end;
  std::size_t run = RUN;
  while (run * RUN < count)
    run *= RUN;
  const std::size_t runs = (count + run - 1) / run;
  const Place middle = begin + static_cast<std::ptrdiff_t>((runs / 2) * run);
  const std::size_t axis = widestAxis(begin, end);
  std::nth_element(begin, middle, end, [axis](const Middle& a, const Middle& b) {
    return a.place[axis] < b.place[axis] ||
           (a.place[axis] == b.place[axis] && a.index < b.index);
  });
  return middle;
}

/** Order boxes so that each run of RUN, and each run of as many runs and
 * so on, lies close together. Log-linear. */
void
arrange(const Stretch& all, WorkCount& work)
{
  const Place middle = halve(all);
  if (middle == all.end ||
      !work.add(HALVING_WORK * static_cast<std::uint64_t>(all.end - all.begin)))
    return;
  arrange({all.begin, middle}, work);
  arrange({middle, all.end}, work);
}

/** The same, with halves side by side once there are some. */
void
arrange(const Stretch& all, int threads, RunControl* control)
{
  RunControl silent(control); // tells no stages
  const LoopContext one_by_one{threads, &silent, "", 1};
  std::vector<Stretch> stretches{all};
  while (threads > 1 &&
         stretches.size() < STRETCHES_A_THREAD * static_cast<std::size_t>(threads)) {
    std::vector<Place> middles(stretches.size(), all.end);
    forEachBlock(
        stretches.size(), one_by_one, [&](std::size_t i, std::size_t, std::size_t) {
          middles[i] = halve(stretches[i]);
        });
    if (one_by_one.cancelled())
      return;
    std::vector<Stretch> halves;
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      halves.push_back({stretches[i].begin, middles[i]});
      halves.push_back({middles[i], stretches[i].end});
    }
    stretches = std::move(halves);
  }
  forEachBlock(
      stretches.size(), one_by_one, [&](std::size_t i, std::size_t, std::size_t) {
        WorkCount work(one_by_one.control);
        arrange(stretches[i], work);
      });
}

} // namespace

std::vector<pcl::index_t>
neighboringOrder(const std::vector<Box>& boxes, int threads, RunControl* control)
{
  std::vector<Middle> middles;
  middles.reserve(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Position sum = boxes[i].min() + boxes[i].max();
    if (!boxes[i].isEmpty())
      middles.push_back({{sum.x(), sum.y(), sum.z()}, static_cast<pcl::index_t>(i)});
  }
  spend(control, middles.size());
  arrange({middles.begin(), middles.end()}, threads, control);
  std::vector<pcl::index_t> order;
  order.reserve(middles.size());
  for (const Middle& middle : middles)
    order.push_back(middle.index);
  return order;
}

BoxTree::BoxTree(const std::vector<Box>& boxes, int threads, RunControl* control)
: order_(neighboringOrder(boxes, threads, control))
{
  build(order_.size(), {threads}, [&](std::size_t place) {
    return boxes[static_cast<std::size_t>(order_[place])];
  });
}

void
BoxTree::setFrame(const Box& bounds)
{
  origin_ = bounds.center();
  const double extent = bounds.sizes().maxCoeff();
  scale_ = extent > 0.0 ? 1.0 / std::max(extent, LEAST_EXTENT) : 1.0;
}

BoxTree::FloatBox
BoxTree::enlarged(const Box& box) const
{
  FloatBox result;
  if (box.isEmpty())
    return result;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    const double middle = origin_[axis];
    result.low[k] = static_cast<float>((box.min()[axis] - middle) * scale_) - MARGIN;
    result.high[k] = static_cast<float>((box.max()[axis] - middle) * scale_) + MARGIN;
  }
  return result;
}

BoxTree::FloatBox
BoxTree::toFrame(const Box& box) const
{
  FloatBox result;
  const auto place = [&](double coordinate, Eigen::Index axis) {
    const double placed = (coordinate - origin_[axis]) * scale_;
    return static_cast<float>(std::clamp(placed, -FARTHEST, FARTHEST));
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    result.low[k] = place(box.min()[axis], axis);
    result.high[k] = place(box.max()[axis], axis);
  }
  return result;
}

BoxTree::Ray
BoxTree::rayFrom(const Position& a, const Position& b) const
{
  const Position from = (a - origin_) * scale_;
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

BoxTree::FloatBox
BoxTree::Node::around() const
{
  FloatBox box;
  for (std::size_t k = 0; k < 3; ++k) {
    box.low[k] = *std::min_element(bounds[0][k], bounds[0][k] + FAN_OUT);
    box.high[k] = *std::max_element(bounds[1][k], bounds[1][k] + FAN_OUT);
  }
  return box;
}

std::array<float, BoxTree::FAN_OUT>
BoxTree::Node::distances(const FloatBox& query) const
{
  std::array<float, FAN_OUT> squared;
  squared.fill(0.0f);
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < FAN_OUT; ++i) {
      const float below = bounds[0][k][i] - query.high[k];
      const float above = query.low[k] - bounds[1][k][i];
      const float apart = std::max(std::max(below, above), 0.0f);
      squared[i] += apart * apart;
    }
  return squared;
}

} // namespace pcl::ccaa
