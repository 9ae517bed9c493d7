// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the command line of pcl_ccaa_reconstruct.
#pragma once

#include "cli.h"
#include "io/status.h"
#include "reconstruct_run.h"

namespace app {

/** \brief All options with their defaults, which are those of the classes. */
CommandLine
makeReconstructCommandLine();

/** \brief Take the settings; fails with one sentence for a value out of range or for
 * options that do not go together. */
Status
takeReconstructSettings(const Arguments& arguments, ReconstructSettings& settings);

} // namespace app
