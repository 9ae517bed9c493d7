// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which of many boxes meet a given box.
#include "mesh/box_tree.h"

#include <cstdint>
#include <utility>

namespace pcl {
namespace ccaa {
namespace {

/** \brief 21 bits spread out so that two free bits follow each. */
std::uint64_t
spread(std::uint64_t bits)
{
  bits = (bits | bits << 32) & 0x001f00000000ffffull;
  bits = (bits | bits << 16) & 0x001f0000ff0000ffull;
  bits = (bits | bits << 8) & 0x100f00f00f00f00full;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3ull;
  bits = (bits | bits << 2) & 0x1249249249249249ull;
  return bits;
}

/** \brief Place along the Morton curve through the unit cube. */
std::uint64_t
mortonCode(const Eigen::Vector3d& share)
{
  constexpr double CELLS = 2097151.0;
  std::uint64_t code = 0;
  for (int k = 0; k < 3; ++k)
    code |= spread(static_cast<std::uint64_t>(std::clamp(share[k], 0.0, 1.0) * CELLS))
            << k;
  return code;
}

Box
boundsOf(const std::vector<Box>& boxes)
{
  Box bounds;
  for (const Box& box : boxes)
    bounds.extend(box);
  return bounds;
}

} // namespace

BoxTree::BoxTree(const std::vector<Box>& boxes)
{
  const Box bounds = boundsOf(boxes);
  if (bounds.isEmpty())
    return;
  const double scale = std::max(bounds.sizes().maxCoeff(), 1e-300);
  std::vector<std::pair<std::uint64_t, pcl::index_t>> keys;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    if (!boxes[i].isEmpty())
      keys.emplace_back(mortonCode((boxes[i].center() - bounds.min()) / scale),
                        static_cast<pcl::index_t>(i));
  std::sort(keys.begin(), keys.end());
  levels_.emplace_back();
  for (const auto& key : keys) {
    items_.push_back(key.second);
    levels_.back().push_back(boxes[static_cast<std::size_t>(key.second)]);
  }
  while (levels_.back().size() > FAN_OUT) {
    const std::vector<Box>& lower = levels_.back();
    std::vector<Box> upper((lower.size() + FAN_OUT - 1) / FAN_OUT);
    for (std::size_t i = 0; i < lower.size(); ++i)
      upper[i / FAN_OUT].extend(lower[i]);
    levels_.push_back(std::move(upper));
  }
}

} // namespace ccaa
} // namespace pcl
