// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the command line of pcl_ccaa_reconstruct.
#pragma once

#include "reconstruct_run.h"

namespace app {

/** \brief What --help says besides the options. */
Usage
reconstructUsage();

/** \brief All options with their defaults, which are those of the classes. */
void
addReconstructOptions(CommandLine& command_line, ReconstructSettings& settings);

/** \brief Only those that change what the chain makes of a cloud. */
void
addChainOptions(CommandLine& command_line, ReconstructSettings& settings);

} // namespace app
