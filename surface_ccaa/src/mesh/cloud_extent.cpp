// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how large a cloud is, and how far from the origin.
#include "mesh/cloud_extent.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::ccaa {
namespace {

/** Points, evenly spread over the list, that tell the extent. */
constexpr std::size_t EXTENT_SAMPLE = 4096;
/** One of so many of them may lie far off on each side. */
constexpr std::size_t STRAY_SHARE = 50;

/** \brief The finite ones of some points; \a looked_at says of how many. */
Positions
finiteSample(const PointView& points, std::size_t& looked_at)
{
  Positions finite;
  const std::size_t stride = 1 + points.size() / EXTENT_SAMPLE;
  looked_at = 0;
  for (std::size_t i = 0; i < points.size(); i += stride, ++looked_at) {
    const Position point = points[i];
    if (point.allFinite())
      finite.push_back(point);
  }
  return finite;
}

} // namespace

double
CloudExtent::floatRounding() const
{
  const double farthest =
      std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  const auto single = static_cast<float>(farthest);
  const float next = std::nextafter(single, std::numeric_limits<float>::infinity());
  return (double{next} - double{single}) / 2.0;
}

CloudExtent
measureExtent(const PointView& points)
{
  CloudExtent extent;
  std::size_t looked_at = 0;
  const Positions sample = finiteSample(points, looked_at);
  if (sample.size() < 3)
    return extent;
  extent.finite = points.size() * sample.size() / looked_at;
  const std::size_t strays = sample.size() / STRAY_SHARE;
  std::vector<double> along(sample.size());
  Position low, high;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    std::transform(sample.begin(), sample.end(), along.begin(), [&](const Position& p) {
      return p[axis];
    });
    std::sort(along.begin(), along.end());
    low[axis] = along[strays];
    high[axis] = along[along.size() - 1 - strays];
  }
  extent.box = {low, high};
  extent.side = (high - low).maxCoeff();
  extent.spacing = extent.side / std::sqrt(static_cast<double>(extent.finite));
  return extent;
}

} // namespace pcl::ccaa
