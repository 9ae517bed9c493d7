// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a progress bar on the terminal.
#pragma once

#include "run/run_control.h"
#include "time_left.h"

#include <chrono>
#include <string>

namespace app {

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
