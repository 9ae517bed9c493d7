// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: positions as floats that keep what matters of them.

#pragma once

#include "icadm/incomplete_model.h"

#include <array>
#include <vector>

namespace pcl::repair {

/** \brief Positions around the middle of their box, in units of its diagonal, for what
 * takes floats only. Those that are not finite do not count for the box. */
inline std::vector<std::array<float, 3>>
localFloats(const Positions& positions)
{
  Eigen::AlignedBox3d box;
  for (const Position& position : positions)
    if (position.allFinite())
      box.extend(position);
  const double size = box.isEmpty() ? 0.0 : box.diagonal().norm();
  const double scale = size > 0.0 ? 1.0 / size : 1.0;
  const Position center = box.isEmpty() ? Position(Position::Zero()) : box.center();
  std::vector<std::array<float, 3>> floats;
  floats.reserve(positions.size());
  for (const Position& position : positions) {
    const Eigen::Vector3f small = (scale * (position - center)).cast<float>();
    floats.push_back({small.x(), small.y(), small.z()});
  }
  return floats;
}

} // namespace pcl::repair
