// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a chain's threads and progress, passed on to its parts.
#include "consecutive/stage_settings.h"

#include <algorithm>

namespace pcl {
namespace ccaa {

ProgressCallback
StageProgress::callback()
{
  return [this](const std::string& stage, double fraction) {
    return reportWithin(stage, fraction);
  };
}

bool
StageProgress::report(double fraction)
{
  return control_.report(name_.c_str(), fraction < 1 ? reached_ : end_);
}

bool
StageProgress::reportWithin(const std::string& stage, double fraction)
{
  if (stage != stage_) {
    stage_ = stage;
    begin_ += width_;
    width_ = (end_ - begin_) / 2;
  }
  const double share = fraction > 0 ? std::min(fraction, 1.0) : 0.0; // NaN is 0
  // A part may come back to a stage; the bar stays where it is then.
  reached_ = std::max(reached_, begin_ + width_ * share);
  return control_.report((name_ + ": " + stage).c_str(), reached_);
}

ScopedSettings::ScopedSettings(RunSettings* settings,
                               unsigned int threads,
                               StageProgress& progress)
: settings_(settings)
{
  if (settings_ == nullptr)
    return;
  own_threads_ = settings_->getNumberOfThreads();
  own_progress_ = settings_->getProgressCallback();
  settings_->setNumberOfThreads(threads);
  settings_->setProgressCallback(progress.callback());
}

ScopedSettings::~ScopedSettings()
{
  if (settings_ == nullptr)
    return;
  settings_->setNumberOfThreads(own_threads_);
  settings_->setProgressCallback(std::move(own_progress_));
}

ScopedSides::ScopedSides(SideSettings* settings, const SideHints& hints)
: settings_(settings)
{
  if (settings_ == nullptr)
    return;
  own_hints_ = settings_->getSideHints();
  settings_->setSideHints(hints);
}

ScopedSides::~ScopedSides()
{
  if (settings_ != nullptr)
    settings_->setSideHints(own_hints_);
}

} // namespace ccaa
} // namespace pcl
