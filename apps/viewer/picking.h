// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what lies at a place of a picture.
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace app {

/** \brief A line that stands for something, such as a boundary loop; or a single point.
 */
struct PickLine {
  std::size_t thing = 0; /**< several lines may stand for one */
  std::vector<Eigen::Vector3d> points;
  bool closed = false;
};

/** \brief Whether something is in front of a place: pixels, and depth from 0 to 1. */
using IsHidden = std::function<bool(const Eigen::Vector3d& place)>;

/** \brief The thing with the line that is nearest to a place of a picture: of those
 * within reach one that is not hidden, else one that is; the lowest of several as near.
 * Knows nothing of windows. Cost: linear in the points of all lines.
 * \param[in] projection to pixels and depth, in homogeneous coordinates; what has no
 * positive last one is behind the camera
 * \param[in] reach pixels
 * \return none where nothing is within reach */
std::optional<std::size_t>
pickNear(const std::vector<PickLine>& lines,
         const Eigen::Matrix4d& projection,
         const Eigen::Vector2d& place,
         double reach,
         const IsHidden& is_hidden);

} // namespace app
