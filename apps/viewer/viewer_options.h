// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the command line of pcl_repair_viewer.
#pragma once

#include "cli/command_line.h"
#include "render/inspection_pictures.h"
#include "viewer/viewer_run.h"

#include <string>
#include <vector>

namespace app {

/** \brief What the user asked pcl_repair_viewer for. */
struct ViewerSettings {
  std::vector<std::string> inputs; /**< none or one: the task's */
  ViewerTask task;
  std::string stage;      /**< empty: the first in a window, the last in a picture */
  std::string screenshot; /**< file; empty: none */
  std::string folder;     /**< for a picture of every stage; empty: none */
  InspectionView view{1280, 800, {}, {}};
  std::string decisions; /**< file; empty: none */
  std::string output;    /**< file of the mesh; empty: one beside the input */
  bool quiet = false;

  /** \brief Whether pictures are asked for and no window. */
  bool
  offScreen() const
  {
    return !screenshot.empty() || !folder.empty();
  }
};

/** \brief What --help says besides the options. */
Usage
viewerUsage();

void
addViewerOptions(CommandLine& command_line, ViewerSettings& settings);

} // namespace app
