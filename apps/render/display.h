// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: makes sure there is an X display to draw with.
#pragma once

namespace app {

/** \brief Whether an X server answers at $DISPLAY. VTK ends the program where none
 * does, even when it draws off-screen. */
bool
hasDisplay();

/** \brief Start this program again, with the same arguments, under a virtual display
 * (xvfb-run). Returns only if that is not possible or was done already. */
void
restartUnderVirtualDisplay(char** arguments);

} // namespace app
