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

/** \brief --repair, and what is to be closed and joined then. */
void
addRepairWishes(CommandLine& command_line, ReconstructSettings& settings);

/** \brief Fails for wishes of a repair that no tile can know what they mean. */
void
checkTileRepair(const pcl::repair::RepairParameters& method);

} // namespace app
