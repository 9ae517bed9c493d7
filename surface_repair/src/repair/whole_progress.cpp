// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how much of a repair is done, over all of its stages.

#include "repair/whole_progress.h"

#include <algorithm>
#include <utility>

namespace pcl::repair {

namespace {

/** Of what is left to do. */
constexpr double CLOSING_SHARE = 0.5;
constexpr double OTHER_SHARE = 0.05;
/** Of what a stage has left. */
constexpr double STEP_SHARE = 0.5;
constexpr const char* CLOSING = "closing";
constexpr const char* LAST = "writing";

double
shareOf(const std::string& stage)
{
  if (stage == LAST)
    return 1.0;
  return stage.rfind(CLOSING, 0) == 0 ? CLOSING_SHARE : OTHER_SHARE;
}

} // namespace

WholeProgress::WholeProgress(ccaa::ProgressCallback told) : told_(std::move(told)) {}

bool
WholeProgress::tell(const std::string& stage, double share)
{
  if (stage.empty()) // asked before anything was reported
    return !told_ || told_(stage_, whole_);
  if (stage != stage_) {
    stage_ = stage;
    begin_ = whole_;
    stage_end_ = end_ = begin_ + (1.0 - begin_) * shareOf(stage);
  }
  else if (share < last_) {
    begin_ = whole_;
    end_ = begin_ + (stage_end_ - begin_) * STEP_SHARE;
  }
  last_ = share;
  whole_ = std::max(whole_, begin_ + (end_ - begin_) * std::clamp(share, 0.0, 1.0));
  return !told_ || told_(stage, whole_);
}

} // namespace pcl::repair
