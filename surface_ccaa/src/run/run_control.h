// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: progress out of a run, cancellation into it.
#pragma once

#include <pcl/surface_ccaa/run_settings.h>

#include <atomic>
#include <thread>
#include <utility>

namespace pcl {
namespace ccaa {

/** \brief One run's view of its progress callback.
 *
 * Only the thread that made it tells the callback: report() from another one, as
 * cancelled(), only says whether the run goes on. Both are safe from any thread. Once
 * the callback has said false it is not asked again.
 */
class RunControl {
public:
  explicit RunControl(ProgressCallback callback = {}) : callback_(std::move(callback))
  {}

  /** \brief Tell the callback where the run stands.
   * \return false when the run is to stop. */
  bool
  report(const char* stage, double fraction)
  {
    if (cancelled())
      return false;
    if (std::this_thread::get_id() != owner_)
      return true;
    if (callback_ && !wantsMore(stage, fraction))
      cancelled_.store(true, std::memory_order_relaxed);
    return !cancelled();
  }

  bool
  cancelled() const
  {
    return cancelled_.load(std::memory_order_relaxed);
  }

private:
  bool
  wantsMore(const char* stage, double fraction) const
  {
    try {
      return callback_(stage, fraction);
    }
    catch (...) {
      return false;
    }
  }

  ProgressCallback callback_;
  std::thread::id owner_ = std::this_thread::get_id();
  std::atomic<bool> cancelled_{false};
};

} // namespace ccaa
} // namespace pcl
