// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the files that keys of the viewer write.
#pragma once

#include <pcl/surface_repair/decisions.h>

#include "viewer/decision_desk.h"
#include "viewer/viewer_options.h"
#include "viewer/viewer_run.h"

#include <string>

namespace app {

/** \brief Writes what is made in a window of one run; settings and run have to outlive
 * it. Nothing is thrown. */
class ViewerFiles {
public:
  ViewerFiles(const ViewerSettings& settings, const ViewerRun& run);

  /** \brief A picture of a stage, to INPUT_STAGE.png in the current folder, beside
   * earlier ones of that name. \param[in] bytes of a PNG file */
  Written
  savePicture(const std::string& stage, const std::string& bytes) const;

  /** \brief To the file of --decisions, or to INPUT_decisions.json beside the input,
   * or where that was there before to INPUT_decisions_2.json and so on. */
  Written
  saveDecisions(const pcl::repair::Decisions& decisions) const;

  /** \brief Repair the whole input as decided, and write it to the file of --output, or
   * to INPUT_repaired.ply beside the input. Cost: that of a repair. */
  Written
  saveMesh(const pcl::repair::Decisions& decisions) const;

private:
  Written
  repairTo(const std::string& output, const pcl::repair::Decisions& decisions) const;

  const ViewerSettings& settings_;
  const ViewerRun& run_;
  std::string decisions_; /**< file */
};

} // namespace app
