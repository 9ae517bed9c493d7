// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how much of a repair is done, over all of its stages.

#pragma once

#include <pcl/surface_ccaa/run_settings.h>

#include <string>

namespace pcl::repair {

/** \brief Tells the share of the whole repair instead of that of a stage: it never
 * falls, and is 1 at the end only.
 *
 * How many passes there will be depends on what they find. So each stage that begins
 * gets a part of what is left: closing half, since more passes come after it as long as
 * they close anything; others less. A step of a stage gets half of what that has left.
 * Within a pass of closing the share is that of the work which the regions are worth.
 */
class WholeProgress {
public:
  /** \param[in] told may be empty */
  explicit WholeProgress(ccaa::ProgressCallback told);

  /** \brief \param[in] share of the stage \return what the callback says */
  bool
  tell(const std::string& stage, double share);

private:
  ccaa::ProgressCallback told_;
  std::string stage_;
  double last_ = 1.0;  /**< share of the step */
  double begin_ = 0.0; /**< of the step, in the whole */
  double end_ = 0.0;
  double stage_end_ = 0.0;
  double whole_ = 0.0;
};

} // namespace pcl::repair
