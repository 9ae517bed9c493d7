// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: lists of indices as sets.
#pragma once

#include <algorithm>
#include <vector>

namespace pcl::ccaa {

/** \brief Let a list ascend and hold each item once. */
template <typename T>
void
sortUnique(std::vector<T>& items)
{
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

} // namespace pcl::ccaa
