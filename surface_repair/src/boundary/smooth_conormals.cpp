// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: where the missing area lies, seen from a jagged boundary.
#include "boundary/smooth_conormals.h"

#include <algorithm>

namespace pcl::repair {
namespace {

/** Share of the curve over which a conormal is taken by default. */
constexpr double WINDOW_SHARE = 0.1;

/** \brief The running integral of tau x n over a closed curve. */
class ConormalIntegral {
public:
  explicit ConormalIntegral(const BoundaryCurve& curve)
  {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double arc = 0.0;
    for (std::size_t k = 0; k < curve.size(); ++k) {
      arcs_.push_back(arc);
      sums_.push_back(sum);
      sum += curve.edge(k).cross(curve.normals[k]); // m = tau x n, times the length
      arc += curve.edge(k).norm();
    }
    arcs_.push_back(arc);
    sums_.push_back(sum);
  }

  double
  length() const
  {
    return arcs_.back();
  }
  double
  arcOf(std::size_t k) const
  {
    return arcs_[k];
  }

  /** \brief The integral from the first point to a place that may lie up to one length
   * outside; `edge` moves forward to it from call to call. */
  Eigen::Vector3d
  upTo(double arc, std::size_t& edge) const
  {
    double turns = 0.0;
    if (arc < 0.0)
      turns = -1.0;
    else if (arc >= length())
      turns = 1.0;
    const double place = arc - turns * length();
    if (place < arcs_[edge])
      edge = 0;
    while (edge + 2 < arcs_.size() && arcs_[edge + 1] <= place)
      ++edge;
    const double step = arcs_[edge + 1] - arcs_[edge];
    const double share = step > 0.0 ? (place - arcs_[edge]) / step : 0.0;
    return turns * sums_.back() + sums_[edge] + share * (sums_[edge + 1] - sums_[edge]);
  }

private:
  std::vector<double> arcs_; /**< of each point, then the whole length */
  std::vector<Eigen::Vector3d> sums_;
};

} // namespace

Directions
smoothConormals(const BoundaryCurve& curve, double window)
{
  Directions conormals;
  if (curve.size() == 0)
    return conormals;
  const ConormalIntegral integral(curve);
  const double share = window > 0.0 ? window : WINDOW_SHARE * integral.length();
  const double half = 0.5 * std::min(share, integral.length());
  conormals.reserve(curve.size());
  std::size_t back = 0;
  std::size_t front = 0;
  for (std::size_t k = 0; k < curve.size(); ++k) {
    const double arc = integral.arcOf(k);
    const Eigen::Vector3d sum =
        integral.upTo(arc + half, front) - integral.upTo(arc - half, back);
    conormals.push_back(sum.normalized()); // 0 stays 0
  }
  return conormals;
}

} // namespace pcl::repair
