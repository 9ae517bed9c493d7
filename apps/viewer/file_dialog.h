// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: asks for a file in a window of its own.
#pragma once

#include <string>

namespace app {

/** \brief Whether the program was built with Qt's widgets. */
bool
hasFileDialog();

/** \brief Let somebody choose the file of a cloud or mesh. Needs a display, and
 * hasFileDialog(). \param[in] title of the window, for what has to be said
 * \param[in] beside a file, in whose folder the choice begins; empty: the current one
 * \return empty where nothing was chosen, and after a signal: interrupted() */
std::string
askForFile(const std::string& title, const std::string& beside);

} // namespace app
