// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which of many boxes meet a given box or segment.
#include "mesh/box_tree.h"

#include "mesh/curve_order.h"

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

/** Operations for a box that is put in order. */
constexpr std::uint64_t ORDER_WORK = 10;

} // namespace

std::vector<pcl::index_t>
neighboringOrder(const std::vector<Box>& boxes, int threads, RunControl* control)
{
  spend(control, ORDER_WORK * boxes.size());
  const auto middleOf = [&](std::size_t i) -> Position {
    if (boxes[i].isEmpty())
      return Position::Constant(std::numeric_limits<double>::quiet_NaN());
    return 0.5 * boxes[i].min() + 0.5 * boxes[i].max(); // of any size
  };
  return curveOrder(boxes.size(), middleOf, threads);
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

/** Of a segment only what lies near the boxes, however long it is: single precision
 * tells where that is. */
BoxTree::Ray
BoxTree::rayFrom(const Position& a, const Position& b) const
{
  Position from = (a - origin_) * scale_;
  Eigen::Vector3d way = (b - a) * scale_;
  double enter = 0.0, leave = 1.0;
  for (int k = 0; k < 3; ++k)
    if (way[k] != 0.0) {
      const auto [first, last] =
          std::minmax({(-1.0 - from[k]) / way[k], (1.0 - from[k]) / way[k]});
      enter = std::max(enter, first);
      leave = std::min(leave, last);
    }
  if (enter < leave) {
    from += enter * way;
    way *= leave - enter;
  }
  Ray ray;
  for (int k = 0; k < 3; ++k) {
    const double inverse = std::clamp(1.0 / way[k], -MOST_INVERSE, MOST_INVERSE);
    std::fill_n(ray.from[k], box_node::WIDTH, static_cast<float>(from[k]));
    std::fill_n(ray.inverse[k], box_node::WIDTH, static_cast<float>(inverse));
    ray.entry[k] = inverse < 0.0 ? 1 : 0;
  }
  return ray;
}

/** Between its corners along any direction lies all of a triangle, so that it does not
 * matter how exact the normal of a needle is. */
BoxTree::Slab
BoxTree::slabOf(const Corners& triangle) const
{
  Slab slab;
  slab.box = toFrame(boxOf(triangle));
  slab.lower = {0, 0, 0};
  const Eigen::Vector3d normal = areaNormal(triangle).normalized();
  if (!normal.allFinite())
    return slab;
  Eigen::Vector3d rounded;
  for (int k = 0; k < 3; ++k) {
    const auto axis = static_cast<std::size_t>(k);
    slab.normal[axis] = static_cast<float>(normal[k]);
    slab.lower[axis] = normal[k] < 0.0 ? 1 : 0;
    rounded[k] = slab.normal[axis];
  }
  std::array<double, 3> places;
  for (std::size_t i = 0; i < 3; ++i)
    places[i] = rounded.dot((triangle[i] - origin_) * scale_);
  const auto [low, high] = std::minmax_element(places.begin(), places.end());
  slab.low = static_cast<float>(*low);
  slab.high = static_cast<float>(*high);
  return slab;
}

} // namespace pcl::ccaa
