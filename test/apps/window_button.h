// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the button by which a window manager closes a window.
#pragma once

namespace app_test {

/** \brief Let a window of $DISPLAY be told what that button tells it.
 * \param[in] window its number in X */
void
pressCloseButton(unsigned long window);

} // namespace app_test
