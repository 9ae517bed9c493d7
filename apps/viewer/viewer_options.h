// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the command line of pcl_repair_viewer.
#pragma once

#include "cli/cli.h"
#include "render/inspection_pictures.h"
#include "viewer/viewer_run.h"

#include <string>

namespace app {

/** \brief What the user asked pcl_repair_viewer for. */
struct ViewerSettings {
  ViewerTask task;
  std::string stage;      /**< empty: the first in a window, the last in a picture */
  std::string screenshot; /**< file; empty: none */
  std::string folder;     /**< for a picture of every stage; empty: none */
  InspectionView view;
  std::string decisions; /**< file; empty: none */
  bool quiet = false;

  /** \brief Whether pictures are asked for and no window. */
  bool
  offScreen() const
  {
    return !screenshot.empty() || !folder.empty();
  }
};

CommandLine
makeViewerCommandLine();

/** \brief Take the settings; fails with one sentence for a value out of range. */
Status
takeViewerSettings(const Arguments& arguments, ViewerSettings& settings);

} // namespace app
