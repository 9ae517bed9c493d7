// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what users want closed and joined, on the command line.
#pragma once

#include <pcl/surface_repair/repair_parameters.h>

#include "cli.h"

namespace app {

/** \brief Add the options of what is to be closed and joined, beside --greatest-hole,
 * for every program that repairs. */
void
addWishOptions(CommandLine& command_line);

/** \brief Take them; fails with one sentence for what cannot be read or contradicts. */
Status
takeWishes(const Arguments& arguments, pcl::repair::RepairParameters& method);

} // namespace app
