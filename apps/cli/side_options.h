// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what user and file tell about the outer side.
#pragma once

#include "cli.h"
#include "io/model.h"
#include "mesh/side_hints.h"

#include <string>

namespace app {

/** \brief Add --viewpoint and --up. */
void
addSideOptions(CommandLine& command_line);

/** \brief Take them; fails with one sentence for what is no place or no direction. */
Status
takeSides(const Arguments& arguments, pcl::ccaa::SideHints& told);

/** \brief What the user has told, and what the file tells. */
pcl::ccaa::SideHints
sidesOf(pcl::ccaa::SideHints told, const Viewpoint& viewpoint);

/** \brief What of a cloud the outer side will be asked first, for people. */
std::string
outerSideBy(const pcl::ccaa::SideHints& told, const Model& model);

/** \brief Note at a model from where its surface is seen, as far as the user has told
 * it or the origin was taken for it: it goes into files with the rest. */
void
noteViewpoint(const pcl::ccaa::SideHints& told,
              const pcl::ccaa::SideTally& tally,
              Viewpoint& viewpoint);

} // namespace app
