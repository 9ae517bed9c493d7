// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a progress bar on the terminal.
#pragma once

#include "run/run_control.h"

#include <chrono>
#include <optional>
#include <string>

namespace app {

/** \brief Estimates the time left of a step from the shares of it that are done.
 *
 * A step lasts as long as the share does not go back; how many steps a run has is not
 * known. Nothing is estimated before a step has gone on for some seconds and has done
 * some of its work. From then on the estimate counts down with the clock, and is drawn
 * slowly to what the pace so far says, so that it does not jump. Knows no clock: times
 * are handed in. */
class TimeLeft {
public:
  /** \brief Seconds that a step has to last before it is worth an estimate. */
  static constexpr double patience = 3.0;

  /** \brief Share of a step by which its pace is known. */
  static constexpr double least_share = 0.05;

  /** \brief Take the share of the step that is done, 0 to 1.
   * \param[in] now seconds since any moment, not less than the last time */
  void
  update(double share, double now);

  /** \brief Seconds left of this step; none if it is too early to tell. */
  std::optional<double>
  seconds() const
  {
    return left_;
  }

private:
  bool has_step_ = false;
  double begin_ = 0;       /**< of the step */
  double begin_share_ = 0; /**< that it began with */
  double last_ = 0;
  double last_share_ = 0;
  std::optional<double> left_;
};

/** \brief A time as "1:05" or "2:01:05", from ten seconds up in steps that people can
 * take seriously when \a coarse. */
std::string
clockText(double seconds, bool coarse);

/** \brief Draws a bar on stderr, when that is a terminal, and passes Ctrl-C on to the
 * run. A run of some seconds is told how long it has taken, and how long its present
 * step will take yet. Nothing is drawn for \a quiet or when stderr goes to a file or
 * pipe. */
class ProgressBar {
public:
  explicit ProgressBar(bool quiet);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar&
  operator=(const ProgressBar&) = delete;

  /** \brief For a run; false from it means a signal has come. Must not outlive the bar.
   */
  pcl::ccaa::ProgressCallback
  callback();

  /** \brief Show a stage of the app itself, such as reading.
   * \return false when a signal has come. */
  bool
  show(const std::string& stage, double fraction);

  /** \brief Wipe the bar off the terminal. */
  void
  clear();

private:
  void
  draw(const std::string& stage, double share, double elapsed) const;

  bool visible_;
  TimeLeft time_left_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  bool drawn_ = false;
  std::string last_stage_;
  std::chrono::steady_clock::time_point last_time_;
};

} // namespace app
