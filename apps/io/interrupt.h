// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: Ctrl-C and termination requests.
#pragma once

#include <string>

namespace app {

/** \brief From now on SIGINT, SIGTERM and SIGHUP only set a flag, so that a run can
 * stop and clean up; a second signal removes temporary files and ends the program at
 * once. A broken pipe becomes an error of the write. */
void
installInterruptHandlers();

/** \brief Whether a signal has come. */
bool
interrupted();

/** \brief Name a file that a second signal removes.
 * \return a number for removeTemporaryFile(); -1 when there is no room for more. */
int
addTemporaryFile(const std::string& path);

/** \brief The file of this number has got its name or is gone. */
void
removeTemporaryFile(int slot);

} // namespace app
