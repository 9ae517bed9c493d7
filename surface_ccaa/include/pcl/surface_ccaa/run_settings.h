// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the settings that every algorithm's run has.
#pragma once

#include <functional>
#include <string>
#include <utility>

namespace pcl::ccaa {

/** \brief Called from the thread that started the run with the name of the stage and
 * the share of a whole chain or repair that is done, else of the stage, 0 to 1. False
 * cancels the run: it stops within 100 ms of work and leaves an empty result, as an
 * exception does, which may not cross the parallel loops of a run. */
using ProgressCallback = std::function<bool(const std::string& stage, double fraction)>;

/** \brief Base of every class of this library that computes: how many threads it uses,
 * and whom it tells about its progress.
 *
 * That an algorithm has this base also tells ConsecutiveReconstruction that it honours
 * indices and leaves out points that are not finite, which not every class of PCL does.
 */
class RunSettings {
public:
  RunSettings() = default;
  RunSettings(const RunSettings&) = default;
  RunSettings&
  operator=(const RunSettings&) = default;
  virtual ~RunSettings() = default;

  /** \brief Threads to use, 0 (the default) = all. The result is the same for any. Set
   * it to leave processors to others. */
  void
  setNumberOfThreads(unsigned int threads)
  {
    threads_ = threads;
  }
  unsigned int
  getNumberOfThreads() const
  {
    return threads_;
  }

  /** \brief See ccaa::ProgressCallback: returning false cancels the run. */
  void
  setProgressCallback(ProgressCallback callback)
  {
    progress_ = std::move(callback);
  }
  const ProgressCallback&
  getProgressCallback() const
  {
    return progress_;
  }

protected:
  unsigned int threads_ = 0;
  ProgressCallback progress_;
};

} // namespace pcl::ccaa
