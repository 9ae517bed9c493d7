// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: space cut so that each part holds as many points.
#include "tiles/bisection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl::ccaa {
namespace {

/** Points within such a part of the longest side from a plane are near it. Of 10
 * million points in 100 tiles the largest has 154 000 with its halo; 159 000 at twice,
 * 173 000 at a quarter of it. */
constexpr double NEAR_PLANE = 1.0 / 16.0;

/** \brief What of a box lies below a plane. */
double
shareBelow(const Box& box, Eigen::Index axis, double plane)
{
  const double low = box.min()[axis], high = box.max()[axis];
  if (plane <= low)
    return 0.0;
  return plane < high ? (plane - low) / (high - low) : 1.0;
}

double
countBelow(const std::vector<CountedBox>& boxes, Eigen::Index axis, double plane)
{
  double count = 0.0;
  for (const CountedBox& box : boxes)
    count += box.count * shareBelow(box.box, axis, plane);
  return count;
}

/** \brief The plane below which most nearly so many points lie, and above it some. */
double
planeBelow(const std::vector<CountedBox>& boxes,
           Eigen::Index axis,
           const Box& around,
           double count)
{
  double low = around.min()[axis], high = around.max()[axis];
  for (double middle = 0.5 * (low + high); low < middle && middle < high;
       middle = 0.5 * (low + high))
    (countBelow(boxes, axis, middle) < count ? low : high) = middle;
  return high;
}

/** \brief Where to cut. */
struct Cut {
  Eigen::Index axis = 0;
  double plane = 0.0;
};

/** \brief Across the axis with the fewest points near the plane: there the parts have
 * the least in common. Where points lie evenly, that is the longest axis. */
Cut
bestCut(const std::vector<CountedBox>& boxes, const Box& around, double count)
{
  const double distance = NEAR_PLANE * around.sizes().maxCoeff();
  Cut best;
  double fewest = std::numeric_limits<double>::infinity();
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    if (!(around.sizes()[axis] > 0.0))
      continue;
    const double plane = planeBelow(boxes, axis, around, count);
    const double near = countBelow(boxes, axis, plane + distance) -
                        countBelow(boxes, axis, plane - distance);
    if (near < fewest) {
      fewest = near;
      best = {axis, plane};
    }
  }
  return best;
}

class Bisection {
public:
  std::vector<Box>
  run(std::vector<CountedBox> boxes, std::uint64_t points_each)
  {
    double count = 0.0;
    for (const CountedBox& box : boxes)
      count += box.count;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const Box space(Position::Constant(-infinity), Position::Constant(infinity));
    share(std::move(boxes), space, count, std::ceil(count / double(points_each)));
    return std::move(parts_);
  }

private:
  void
  share(std::vector<CountedBox> boxes, const Box& space, double count, double parts)
  {
    Box around;
    for (const CountedBox& box : boxes)
      around.extend(box.box);
    if (parts <= 1.0 || !(around.sizes().maxCoeff() > 0.0)) {
      parts_.push_back(space);
      return;
    }
    const auto [axis, plane] =
        bestCut(boxes, around, count * std::floor(0.5 * parts) / parts);
    const double below = countBelow(boxes, axis, plane);
    const double lower =
        std::clamp(std::round(parts * below / count), 1.0, parts - 1.0);
    std::vector<CountedBox> upper_boxes = cutOff(boxes, axis, plane);
    Box lower_space = space, upper_space = space;
    lower_space.max()[axis] = upper_space.min()[axis] = plane;
    share(std::move(boxes), lower_space, below, lower);
    share(std::move(upper_boxes), upper_space, count - below, parts - lower);
  }

  /** \brief Keep what lies below a plane, and give the rest. */
  static std::vector<CountedBox>
  cutOff(std::vector<CountedBox>& boxes, Eigen::Index axis, double plane)
  {
    std::vector<CountedBox> below, above;
    for (const CountedBox& box : boxes) {
      const double share = shareBelow(box.box, axis, plane);
      if (share > 0.0) {
        below.push_back({box.box, box.count * share});
        below.back().box.max()[axis] = std::min(box.box.max()[axis], plane);
      }
      if (box.box.max()[axis] >= plane) {
        above.push_back({box.box, box.count * (1.0 - share)});
        above.back().box.min()[axis] = std::max(box.box.min()[axis], plane);
      }
    }
    boxes = std::move(below);
    return above;
  }

  std::vector<Box> parts_;
};

} // namespace

std::vector<Box>
bisect(const std::vector<CountedBox>& boxes, std::uint64_t points_each)
{
  return boxes.empty() ? std::vector<Box>() : Bisection().run(boxes, points_each);
}

} // namespace pcl::ccaa
