// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: places and directions along a closed curve by arc length.
#include "field/curve_walk.h"

#include <algorithm>
#include <cmath>

namespace pcl::repair {

CurveWalk::CurveWalk(const BoundaryCurve& curve) : curve_(curve)
{
  arcs_.reserve(curve.size() + 1);
  arcs_.push_back(0.0);
  normal_integrals_.reserve(curve.size() + 1);
  normal_integrals_.push_back(Eigen::Vector3d::Zero());
  for (std::size_t k = 0; k < curve.size(); ++k) {
    const double length = curve.edge(k).norm();
    arcs_.push_back(arcs_.back() + length);
    normal_integrals_.push_back(normal_integrals_.back() + length * normalOf(k));
  }
}

double
CurveWalk::wrapped(double arc) const
{
  const double rest = arc - std::floor(arc / length()) * length();
  return std::clamp(rest, 0.0, length());
}

std::size_t
CurveWalk::edgeAt(double arc) const
{
  const auto above = std::upper_bound(arcs_.begin(), arcs_.end(), wrapped(arc));
  const auto point = static_cast<std::size_t>(above - arcs_.begin());
  return std::min(point, curve_.size()) - 1;
}

double
CurveWalk::shareOf(std::size_t k, double arc) const
{
  const double length = arcs_[k + 1] - arcs_[k];
  return length > 0.0 ? (arc - arcs_[k]) / length : 0.0;
}

Eigen::Vector3d
CurveWalk::normalOf(std::size_t k) const
{
  return curve_.normals[k].allFinite() ? curve_.normals[k] : Eigen::Vector3d::Zero();
}

Position
CurveWalk::positionAt(double arc) const
{
  const std::size_t k = edgeAt(arc);
  return curve_.points[k] + shareOf(k, wrapped(arc)) * curve_.edge(k);
}

Eigen::Vector3d
CurveWalk::normalIntegral(double arc) const
{
  const std::size_t k = edgeAt(arc);
  const double turns = std::floor(arc / length());
  return turns * normal_integrals_.back() + normal_integrals_[k] +
         (wrapped(arc) - arcs_[k]) * normalOf(k);
}

} // namespace pcl::repair
