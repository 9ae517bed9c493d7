// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a chain's threads and progress, passed on to its parts.
#include "consecutive/stage_settings.h"

#include <algorithm>

namespace pcl::ccaa {

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

ScopedSettings::ScopedSettings(const StageSettings& settings,
                               unsigned int threads,
                               const SideHints& hints,
                               StageProgress& progress)
: settings_(settings)
{
  if (settings_.run != nullptr) {
    own_threads_ = settings_.run->getNumberOfThreads();
    own_progress_ = settings_.run->getProgressCallback();
    settings_.run->setNumberOfThreads(threads);
    settings_.run->setProgressCallback(progress.callback());
  }
  if (settings_.sides != nullptr) {
    own_hints_ = settings_.sides->getSideHints();
    settings_.sides->setSideHints(hints);
  }
}

ScopedSettings::~ScopedSettings()
{
  if (settings_.run != nullptr) {
    settings_.run->setNumberOfThreads(own_threads_);
    settings_.run->setProgressCallback(std::move(own_progress_));
  }
  if (settings_.sides != nullptr)
    settings_.sides->setSideHints(own_hints_);
}

} // namespace pcl::ccaa
