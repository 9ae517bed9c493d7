// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a progress bar on the terminal.
#include "progress.h"

#include "interrupt.h"
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace app {
namespace {

constexpr std::size_t bar_width = 30;
constexpr std::chrono::milliseconds redraw_interval{100};

} // namespace

ProgressBar::ProgressBar(bool quiet) : visible_(!quiet && isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() { clear(); }

pcl::ccaa::ProgressCallback
ProgressBar::callback()
{
  return [this](const std::string& stage, double fraction) {
    return show(stage, fraction);
  };
}

bool
ProgressBar::show(const std::string& stage, double fraction)
{
  const auto now = std::chrono::steady_clock::now();
  const bool is_due = stage != last_stage_ || now - last_time_ >= redraw_interval;
  if (visible_ && is_due) {
    const double share = std::clamp(std::isfinite(fraction) ? fraction : 0.0, 0.0, 1.0);
    const auto filled = static_cast<std::size_t>(share * bar_width);
    std::cerr << "\r[" << std::string(filled, '#')
              << std::string(bar_width - filled, '.') << "] "
              << static_cast<int>(share * 100) << " % " << stage << "\x1b[K"
              << std::flush;
    drawn_ = true;
    last_stage_ = stage;
    last_time_ = now;
  }
  return !interrupted();
}

void
ProgressBar::clear()
{
  if (drawn_)
    std::cerr << "\r\x1b[K" << std::flush;
  drawn_ = false;
}

} // namespace app
