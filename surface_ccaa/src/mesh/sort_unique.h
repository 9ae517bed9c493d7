// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: lists of indices as sets.
#pragma once

#include <pcl/types.h>

#include <algorithm>
#include <vector>

namespace pcl {
namespace ccaa {

/** \brief Let a list ascend and hold each index once. */
inline void
sortUnique(std::vector<index_t>& indices)
{
  std::sort(indices.begin(), indices.end());
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
}

} // namespace ccaa
} // namespace pcl
