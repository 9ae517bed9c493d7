// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: an X display to draw with.
#include "render/display.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <X11/Xlib.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <string>

namespace app {
namespace {

constexpr int SECONDS_TO_START = 30;
constexpr int MILLISECONDS_TO_END = 2000;

/** \brief Become the server, which writes the number of its display to \a output. Only
 * what a forked process may call. */
[[noreturn]] void
becomeServer(int output, const char* output_number)
{
  setpgid(0, 0);                    // Ctrl-C is for us alone to answer
  prctl(PR_SET_PDEATHSIG, SIGTERM); // it ends with us, however we end
  const int nowhere = open("/dev/null", O_RDWR);
  for (const int stream : {0, 1, 2})
    dup2(nowhere, stream);
  fcntl(output, F_SETFD, 0);
  execlp("Xvfb",
         "Xvfb",
         "-displayfd",
         output_number,
         "-screen",
         "0",
         "1280x1024x24",
         "-nolisten",
         "tcp",
         static_cast<char*>(nullptr));
  _exit(127);
}

/** \brief The line that the server writes once it is ready; empty when it ends or takes
 * too long. */
std::string
readLine(int input)
{
  std::string line;
  pollfd wait{input, POLLIN, 0};
  while (poll(&wait, 1, 1000 * SECONDS_TO_START) > 0) {
    char letter = 0;
    if (read(input, &letter, 1) != 1)
      return {};
    if (letter == '\n')
      return line;
    line += letter;
  }
  return {};
}

/** \brief Start a virtual display and name it in $DISPLAY.
 * \return its process, -1 if there is none */
pid_t
startServer()
{
  std::array<int, 2> channel{};
  if (pipe2(channel.data(), O_CLOEXEC) != 0)
    return -1;
  const std::string output_number = std::to_string(channel[1]);
  const pid_t server = fork();
  if (server == 0)
    becomeServer(channel[1], output_number.c_str());
  close(channel[1]);
  const std::string number = server > 0 ? readLine(channel[0]) : "";
  close(channel[0]);
  if (!number.empty())
    setenv("DISPLAY", (":" + number).c_str(), 1);
  return server;
}

bool
ends(pid_t server)
{
  for (int waited = 0; waited < MILLISECONDS_TO_END; waited += 10) {
    if (waitpid(server, nullptr, WNOHANG) != 0)
      return true;
    poll(nullptr, 0, 10);
  }
  return false;
}

} // namespace

bool
waitForEvents(void* display, int milliseconds)
{
  auto* const opened = static_cast<::Display*>(display);
  pollfd wait{ConnectionNumber(opened), POLLIN, 0};
  if (XPending(opened) == 0)
    poll(&wait, 1, milliseconds);
  return XPending(opened) > 0;
}

bool
isAwaited(void* display)
{
  bool found = false;
  const auto look = [](::Display* /*display*/, XEvent* event, XPointer result) -> Bool {
    const std::array<int, 4> answered = {
        KeyPress, ButtonPress, ConfigureNotify, ClientMessage};
    if (std::find(answered.begin(), answered.end(), event->type) != answered.end())
      *reinterpret_cast<bool*>(result) = true;
    return False; // it stays in the queue
  };
  XEvent none;
  XCheckIfEvent(static_cast<::Display*>(display),
                &none,
                look,
                reinterpret_cast<XPointer>(&found));
  return found;
}

bool
hasDisplay()
{
  // Never closed: a virtual server starts afresh when its last client leaves, and for a
  // moment refuses the next one.
  return XOpenDisplay(nullptr) != nullptr;
}

Display::Display() : ready_(hasDisplay())
{
  if (ready_)
    return;
  server_ = startServer();
  ready_ = server_ > 0 && hasDisplay();
}

Display::~Display()
{
  if (server_ <= 0)
    return;
  kill(server_, SIGTERM);
  if (ends(server_))
    return;
  kill(server_, SIGKILL); // Xvfb misses a signal now and then, and would sleep for ever
  waitpid(server_, nullptr, 0);
}

} // namespace app
