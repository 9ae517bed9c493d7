// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which of many boxes meet a given box.
#include "mesh/box_tree.h"

#include "mesh/morton_code.h"

#include <cstdint>
#include <utility>

namespace pcl {
namespace ccaa {
namespace {

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
