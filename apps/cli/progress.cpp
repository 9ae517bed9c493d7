// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a progress bar on the terminal.
#include "progress.h"

#include "io/interrupt.h"
#include "io/wording.h"
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace app {
namespace {

constexpr std::size_t bar_width = 30;
constexpr std::chrono::milliseconds redraw_interval{100};

/** Less is not worth telling, and "0:00 more" would be wrong as often as right. */
constexpr double least_told_seconds = 1.0;

/** Seconds in which the estimate comes near to what the pace says. */
constexpr double inertia = 5.0;

/** Longest time that is told, in seconds. */
constexpr double longest = 359999.0;

} // namespace

void
TimeLeft::update(double share, double now)
{
  if (!std::isfinite(share))
    return;
  share = std::clamp(share, 0.0, 1.0);
  if (!has_step_ || share < last_share_) {
    has_step_ = true;
    begin_ = now;
    begin_share_ = share;
    left_.reset();
  }
  const double passed = now - last_;
  last_ = now;
  last_share_ = share;
  const double whole = 1.0 - begin_share_;
  const double done = whole > 0 ? (share - begin_share_) / whole : 1.0;
  if (now - begin_ < patience || done < least_share)
    return;
  const double by_pace = (now - begin_) * (1.0 - done) / done;
  if (!left_) {
    left_ = by_pace;
    return;
  }
  const double by_clock = std::max(0.0, *left_ - passed);
  left_ = by_clock + (by_pace - by_clock) * (1.0 - std::exp(-passed / inertia));
}

std::string
clockText(double seconds, bool coarse)
{
  seconds = std::clamp(seconds, 0.0, longest);
  double step = 1.0;
  if (coarse && seconds >= 10)
    step = seconds < 60 ? 5 : seconds < 600 ? 10 : 60;
  const auto whole = static_cast<long>(std::lround(seconds / step) * std::lround(step));
  const long minutes = whole / 60;
  return minutes < 60
             ? formatted("%ld:%02ld", minutes, whole % 60)
             : formatted("%ld:%02ld:%02ld", minutes / 60, minutes % 60, whole % 60);
}

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
  if (!visible_)
    return !interrupted();
  const auto now = std::chrono::steady_clock::now();
  const double elapsed = std::chrono::duration<double>(now - begin_).count();
  time_left_.update(fraction, elapsed);
  if (stage != last_stage_ || now - last_time_ >= redraw_interval) {
    const double share = std::isfinite(fraction) ? fraction : 0.0;
    draw(stage, std::clamp(share, 0.0, 1.0), elapsed);
    drawn_ = true;
    last_stage_ = stage;
    last_time_ = now;
  }
  return !interrupted();
}

void
ProgressBar::draw(const std::string& stage, double share, double elapsed) const
{
  const auto filled = static_cast<std::size_t>(share * bar_width);
  std::cerr << "\r[" << std::string(filled, '#') << std::string(bar_width - filled, '.')
            << "] " << static_cast<int>(share * 100) << " % " << stage;
  if (elapsed >= TimeLeft::patience)
    std::cerr << ", " << clockText(elapsed, false);
  const auto left = time_left_.seconds();
  if (left && *left >= least_told_seconds)
    std::cerr << ", step about " << clockText(*left, true) << " more";
  std::cerr << "\x1b[K" << std::flush;
}

void
ProgressBar::clear()
{
  if (drawn_)
    std::cerr << "\r\x1b[K" << std::flush;
  drawn_ = false;
}

} // namespace app
