// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: an X display to draw with.
#pragma once

#include <sys/types.h>

namespace app {

/** \brief The X display that pictures are drawn with: that of $DISPLAY, or else a
 * virtual one (Xvfb), which is started for this object, named in $DISPLAY and ended
 * with it. VTK ends the program where there is none, even when it draws off-screen. */
class Display {
public:
  Display();
  ~Display();
  Display(const Display&) = delete;
  Display&
  operator=(const Display&) = delete;

  /** \brief Whether there is something to draw with. */
  bool
  ready() const
  {
    return ready_;
  }

private:
  bool ready_;
  pid_t server_ = -1; /**< the virtual display, if one was started */
};

/** \brief Wait until events have come from a display that X's library has opened.
 * \return false where none came in time */
bool
waitForEvents(void* display, int milliseconds);

/** \brief Whether a key or a button waits to be answered, or the window to be closed or
 * laid out anew: more than a mouse that moves. \param[in] display see waitForEvents()
 */
bool
isAwaited(void* display);

/** \brief Whether $DISPLAY names a display that answers, for a window that somebody is
 * to see. */
bool
hasDisplay();

} // namespace app
