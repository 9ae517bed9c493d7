// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: narrow folds of the model that run out at a boundary.

#include <Eigen/Geometry>

#include "junction/junction.h"
#include "mesh/corners.h"
#include "survey/crease_ends.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::repair {

namespace {

/** Least angle, radians, between both sides of a fold. */
constexpr double LEAST_FOLD = 1.5707963267948966;
/** Points on either side of one that tell where a loop runs. */
constexpr std::size_t COURSE = 3;
/** Widest fold, of its loop: that of a round limb turns by 36 degrees there. */
constexpr double WIDEST = 0.1;
/** Of half the width of a fold: its middle, the sides are beyond. */
constexpr double THIRD = 1.0 / 3.0;

/** The surface along a loop, by the arc length of its course: of means of some points,
 * since a rim may go to and fro. */
class LoopNormals {
public:
  explicit LoopNormals(const BoundaryLoop& loop) : curve_(loop.curve)
  {
    sums_.emplace_back(Direction::Zero());
    arcs_.push_back(0.0);
    for (std::size_t k = 0; k < 3 * curve_.size(); ++k) { // so that no range wraps
      const std::size_t edge = k % curve_.size();
      const double length = (courseAt(curve_.next(edge)) - courseAt(edge)).norm();
      sums_.push_back(sums_.back() + length * curve_.normals[edge]);
      arcs_.push_back(arcs_.back() + length);
    }
  }

  double
  length() const
  {
    return arcs_[curve_.size()];
  }
  double
  arcOf(std::size_t vertex) const
  {
    return arcs_[vertex];
  }

  /** The mean normal from one arc length after a vertex to another, at most a whole
   * loop away; unit. */
  Direction
  mean(std::size_t vertex, double from, double to) const
  {
    const double origin = length() + arcs_[vertex];
    return (sumAt(origin + to) - sumAt(origin + from)).normalized();
  }

private:
  Position
  courseAt(std::size_t vertex) const
  {
    Position sum = Position::Zero();
    for (std::size_t step = 0; step <= 2 * COURSE; ++step)
      sum += curve_.points[(vertex + curve_.size() + step - COURSE % curve_.size()) %
                           curve_.size()];
    return sum / (2.0 * COURSE + 1.0);
  }

  Eigen::Vector3d
  sumAt(double arc) const
  {
    const auto after = std::upper_bound(arcs_.begin(), arcs_.end() - 1, arc);
    const auto k = static_cast<std::size_t>(after - arcs_.begin()) - 1;
    return sums_[k] + (arc - arcs_[k]) * curve_.normals[k % curve_.size()];
  }

  const BoundaryCurve& curve_;
  std::vector<double> arcs_; /**< at the points, three times round */
  std::vector<Eigen::Vector3d> sums_;
};

/** The normals on the two sides of a fold and in its middle. */
struct Fold {
  Direction before, middle, after;

  Fold(const LoopNormals& normals, std::size_t vertex, double width)
  : before(normals.mean(vertex, -0.5 * width, -THIRD * 0.5 * width))
  , middle(normals.mean(vertex, -THIRD * 0.5 * width, THIRD * 0.5 * width))
  , after(normals.mean(vertex, THIRD * 0.5 * width, 0.5 * width))
  {}

  bool
  isSharp() const
  {
    return ccaa::angleBetween(before, after) >= LEAST_FOLD;
  }
  double
  offMiddle() const
  {
    return std::abs(ccaa::angleBetween(before, middle) -
                    ccaa::angleBetween(middle, after));
  }
  /** \param[in] along the way the surface goes on */
  bool
  isConvex(const Direction& along) const
  {
    return (before.cross(middle) + middle.cross(after)).dot(along) < 0.0;
  }
};

} // namespace

std::vector<CreaseEnd>
foldEnds(SurfaceEnds& surface_ends,
         const BoundaryLoop& loop,
         double width,
         const std::vector<CreaseEnd>& known)
{
  const LoopNormals normals(loop);
  width = std::min(width, WIDEST * normals.length());
  if (!(width > 0.0))
    return {};
  std::vector<std::pair<double, std::size_t>> middles; // how far off the middle
  for (std::size_t k = 0; k < loop.vertices.size(); ++k) {
    const Fold fold(normals, k, width);
    if (fold.isSharp())
      middles.emplace_back(fold.offMiddle(), k);
  }
  std::sort(middles.begin(), middles.end());
  std::vector<double> taken;
  for (const CreaseEnd& end : known)
    taken.push_back(normals.arcOf(end.vertex));
  std::vector<CreaseEnd> ends;
  for (const auto& [off, k] : middles) {
    const double arc = normals.arcOf(k);
    if (std::any_of(taken.begin(), taken.end(), [&](double other) {
          const double apart = std::abs(arc - other);
          return std::min(apart, normals.length() - apart) < width;
        }))
      continue;
    taken.push_back(arc);
    const SurfaceEnd& surface = surface_ends.at(loop.vertices[k]);
    ends.push_back({k,
                    surface.conormal,
                    surface.normal,
                    Fold(normals, k, width).isConvex(surface.conormal),
                    surface.edge});
  }
  return ends;
}

} // namespace pcl::repair
