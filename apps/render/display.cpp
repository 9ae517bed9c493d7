// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: makes sure there is an X display to draw with.
#include "render/display.h"

#include <unistd.h>
#include <X11/Xlib.h>

#include <cstdlib>
#include <string>
#include <vector>

namespace app {
namespace {

/** \brief Set for the program we start, so that it does not start itself for ever. */
constexpr const char* RESTARTED = "PCL_RENDER_MESH_RESTARTED";

} // namespace

bool
hasDisplay()
{
  // Never closed: a virtual server starts afresh when its last client leaves, and for a
  // moment refuses the next one.
  static Display* const display = XOpenDisplay(nullptr);
  return display != nullptr;
}

void
restartUnderVirtualDisplay(char** arguments)
{
  if (std::getenv(RESTARTED) != nullptr)
    return;
  setenv(RESTARTED, "1", 1);
  std::string launcher = "xvfb-run";
  std::string automatic = "-a";
  std::vector<char*> command{launcher.data(), automatic.data()};
  for (; *arguments != nullptr; ++arguments)
    command.push_back(*arguments);
  command.push_back(nullptr);
  execvp(command[0], command.data());
}

} // namespace app
