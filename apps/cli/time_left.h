// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how long a step will take yet.
#pragma once

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

} // namespace app
