// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the button by which a window manager closes a window.
#include "window_button.h"

#include <X11/Xlib.h>

namespace app_test {

void
pressCloseButton(unsigned long window)
{
  ::Display* const display = XOpenDisplay(nullptr);
  if (display == nullptr)
    return;
  XEvent event{};
  event.xclient.type = ClientMessage;
  event.xclient.window = window;
  event.xclient.message_type = XInternAtom(display, "WM_PROTOCOLS", False);
  event.xclient.format = 32;
  event.xclient.data.l[0] =
      static_cast<long>(XInternAtom(display, "WM_DELETE_WINDOW", False));
  XSendEvent(display, window, False, NoEventMask, &event);
  XCloseDisplay(display);
}

} // namespace app_test
