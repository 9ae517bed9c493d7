// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a chain's threads and progress, passed on to its parts.
#pragma once

#include <pcl/surface_ccaa/impl/cloud_runs.h>

#include "run/run_control.h"

#include <string>
#include <utility>

namespace pcl::ccaa {

/** \brief One part of a chain to the user's progress callback: the stage is told as
 * "start: edges", the fraction is that of the whole chain and never goes back.
 *
 * How many stages the part has itself is not known. So its first one gets the first
 * half of the part's share, the second one half of the rest, and so on. */
class StageProgress {
public:
  /** \param[in] begin,end share of the whole chain, 0 to 1 */
  StageProgress(RunControl& control, std::string name, double begin, double end)
  : control_(control), name_(std::move(name)), begin_(begin), end_(end), reached_(begin)
  {}

  /** \brief A callback for the part; must not outlive this object. */
  ProgressCallback
  callback();

  /** \brief Tell that the part begins, or with 1 that it has ended.
   * \return false when the run is to stop */
  bool
  report(double fraction);

private:
  bool
  reportWithin(const std::string& stage, double fraction);

  RunControl& control_;
  std::string name_;
  std::string stage_; /**< of the part */
  double begin_;      /**< of the part's present stage */
  double end_;
  double width_ = 0; /**< of the part's present stage */
  double reached_;   /**< told last */
};

/** \brief Gives a part the threads and the progress of the chain, and what the chain
 * knows about the outer side; its own settings back at the end. */
class ScopedSettings {
public:
  ScopedSettings(const StageSettings& settings,
                 unsigned int threads,
                 const SideHints& hints,
                 StageProgress& progress);
  ~ScopedSettings();
  ScopedSettings(const ScopedSettings&) = delete;
  ScopedSettings&
  operator=(const ScopedSettings&) = delete;

private:
  StageSettings settings_;
  unsigned int own_threads_ = 0;
  ProgressCallback own_progress_;
  SideHints own_hints_;
};

/** \brief Calls a function at the end of its life, also when an exception ends it. */
template <typename Function>
class AtEnd {
public:
  explicit AtEnd(Function function) : function_(std::move(function)) {}
  ~AtEnd() { function_(); }
  AtEnd(const AtEnd&) = delete;
  AtEnd&
  operator=(const AtEnd&) = delete;

private:
  Function function_;
};

} // namespace pcl::ccaa
