// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: progress out of a run, cancellation and budgets into it.
#pragma once

#include <pcl/surface_ccaa/run_settings.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <string>
#include <thread>
#include <utility>

namespace pcl::ccaa {

/** \brief One run's view of its progress callback, or the budget of a part of it.
 *
 * Only the thread that made it tells the callback: report() from another one, as
 * cancelled(), only says whether the run goes on. All are safe from any thread. Once
 * the callback has said false it is not asked again.
 *
 * Work is counted in operations of some 10 ns: a triangle weighed, a pair of triangles
 * tested, ten multiplications. The count depends on the input alone, not on the machine
 * or the number of threads.
 */
class RunControl {
public:
  /** \brief Operations after which the callback is asked again, if nothing was reported
   * in between: some 10 ms. */
  static constexpr std::uint64_t PATIENCE = 1000000;

  explicit RunControl(ProgressCallback callback = {}) : callback_(std::move(callback))
  {}

  /** \brief A part of a run: stops with the whole, and when it has taken more work than
   * it may. It tells no stages. \param[in] whole null, or else must outlive the part */
  explicit RunControl(RunControl* whole, std::uint64_t most_work = UINT64_MAX)
  : whole_(whole), most_work_(most_work)
  {}

  /** \brief Tell the callback where the run stands.
   * \return false when the run is to stop. */
  bool
  report(const char* stage, double fraction)
  {
    if (whole_ != nullptr || cancelled() || std::this_thread::get_id() != owner_)
      return !cancelled();
    if (stage_ != stage)
      stage_ = stage;
    fraction_ = fraction;
    ask();
    return !cancelled();
  }

  /** \brief Tell what was done since the last call: little enough that a run can be
   * left soon, PATIENCE at most. \return false when the run or this part of it is to
   * stop. */
  bool
  spend(std::uint64_t operations)
  {
    if (most_work_ <
        work_.fetch_add(operations, std::memory_order_relaxed) + operations)
      cancelled_.store(true, std::memory_order_relaxed);
    if (whole_ != nullptr)
      whole_->spend(operations);
    else if (std::this_thread::get_id() == owner_) {
      unasked_ += operations;
      longest_unasked_ = std::max(longest_unasked_, unasked_);
      if (unasked_ >= PATIENCE && !cancelled())
        ask();
    }
    return !cancelled();
  }

  /** \brief Ask the callback again while others work. \return as spend() */
  bool
  askAgain()
  {
    if (whole_ != nullptr)
      whole_->askAgain();
    else if (std::this_thread::get_id() == owner_ && !cancelled())
      ask();
    return !cancelled();
  }

  /** \brief The run is to stop, or the part of it has spent what it may. */
  bool
  cancelled() const
  {
    return cancelled_.load(std::memory_order_relaxed) ||
           (whole_ != nullptr && whole_->cancelled());
  }

  /** \brief Operations that were counted, those of its parts too. */
  std::uint64_t
  work() const
  {
    return work_.load(std::memory_order_relaxed);
  }

  /** \brief The most operations between two calls of the callback. */
  std::uint64_t
  longestUnasked() const
  {
    return longest_unasked_;
  }

private:
  void
  ask()
  {
    unasked_ = 0;
    if (callback_ && !wantsMore())
      cancelled_.store(true, std::memory_order_relaxed);
  }

  bool
  wantsMore() const
  {
    try {
      return callback_(stage_, fraction_);
    }
    catch (...) {
      return false;
    }
  }

  ProgressCallback callback_;
  std::string stage_; /**< reported last */
  double fraction_ = 0.0;
  std::thread::id owner_ = std::this_thread::get_id();
  std::atomic<bool> cancelled_{false};
  RunControl* whole_ = nullptr;
  std::uint64_t most_work_ = UINT64_MAX;
  std::atomic<std::uint64_t> work_{0};
  std::uint64_t unasked_ = 0; /**< of the owner, since the callback was asked */
  std::uint64_t longest_unasked_ = 0;
};

/** \brief The same where there may be no control: \return whether to go on */
inline bool
spend(RunControl* control, std::uint64_t operations)
{
  return control == nullptr || control->spend(operations);
}

/** \brief The work of many small steps, told together so that counting costs next to
 * nothing. Of one thread; tells what is left when it ends. */
class WorkCount {
public:
  /** \param[in] control null, or else must outlive the count */
  explicit WorkCount(RunControl* control) : control_(control) {}
  WorkCount(const WorkCount&) = delete;
  WorkCount&
  operator=(const WorkCount&) = delete;
  ~WorkCount()
  {
    if (untold_ > 0)
      tell();
  }

  /** \return false when the run or its part is to stop, as far as was asked */
  bool
  add(std::uint64_t operations)
  {
    untold_ += operations;
    return untold_ < MOST_UNTOLD || tell();
  }

  /** \brief Tell what was not told yet. \return as spend() */
  bool
  tell()
  {
    return spend(control_, std::exchange(untold_, 0));
  }

private:
  static constexpr std::uint64_t MOST_UNTOLD = 10000; /**< operations */
  RunControl* control_;
  std::uint64_t untold_ = 0;
};

inline bool
isCancelled(const RunControl* control)
{
  return control != nullptr && control->cancelled();
}

} // namespace pcl::ccaa
