// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what the viewer shows, made in tests.
#pragma once

#include <gtest/gtest.h>

#include "app_runner.h"
#include "model_samples.h"
#include "viewer/viewer_run.h"

namespace app_test {

/** \brief The run of a viewer that opens a mesh; fails the test if it fails. */
inline app::ViewerRun
runForViewer(const pcl::PolygonMesh& mesh,
             const pcl::repair::RepairParameters& method = {})
{
  const TemporaryFolder folder;
  app::ViewerTask task;
  task.input = folder.path("mesh.ply");
  task.method = method;
  save(task.input, mesh);
  app::ProgressBar bar(true);
  app::ViewerRun run;
  app::readForViewer(task, run);
  app::runForViewer(task, bar, run);
  return run;
}

} // namespace app_test
