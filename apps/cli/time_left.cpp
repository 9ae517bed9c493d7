// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how long a step will take yet.
#include "time_left.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace app {
namespace {

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
  char text[32];
  if (whole >= 3600)
    std::snprintf(text,
                  sizeof(text),
                  "%ld:%02ld:%02ld",
                  whole / 3600,
                  whole / 60 % 60,
                  whole % 60);
  else
    std::snprintf(text, sizeof(text), "%ld:%02ld", whole / 60, whole % 60);
  return text;
}

} // namespace app
