// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how long a stage takes.
#pragma once

#include <chrono>

namespace pcl::ccaa {

/** \brief Wall-clock seconds since it was made. */
class StageClock {
public:
  double
  seconds() const
  {
    return std::chrono::duration<double>(Clock::now() - start_).count();
  }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

} // namespace pcl::ccaa
