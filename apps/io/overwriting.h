// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: keeps scans from being written over.
#pragma once

#include "status.h"

#include <string>

namespace app {

/** \brief Whether clouds of others may be written over from now on; they may not at
 * first. Not to be called while threads write. */
void
allowLosingClouds(bool allowed);

/** \brief Fails when \a path is a file with points but no triangles that does not carry
 * our mark, such as a scan, unless that is allowed. Files of unknown formats, devices,
 * and names of nothing pass. Reads the first bytes; of VTK, OBJ and OFF the whole file.
 */
Status
checkReplaceable(const std::string& path);

} // namespace app
