// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the value below which a share of others lies.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace pcl::ccaa {

/** \brief The value that a share (0 to below 1) of some values stays below, or `none`
 * where there are none. Linear. */
template <typename T>
T
quantile(std::vector<T> values, double share, T none = T(0))
{
  if (values.empty())
    return none;
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(
                                          share * static_cast<double>(values.size()));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

/** \brief The middle one of some values, the higher of two; 0 without any. */
template <typename T>
T
medianOf(std::vector<T> values)
{
  return quantile(std::move(values), 0.5);
}

/** \brief Standard deviation of normally distributed values around 0, robustly: from
 * the median of their absolute values; 0 without any. */
inline double
deviationOf(std::vector<double> absolute)
{
  return 1.4826 * medianOf(std::move(absolute));
}

} // namespace pcl::ccaa
