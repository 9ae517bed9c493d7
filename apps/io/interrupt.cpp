// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: Ctrl-C and termination requests.
#include "interrupt.h"

#include "status.h"
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstring>

namespace app {
namespace {

std::atomic<bool> signal_came{false};
static_assert(std::atomic<bool>::is_always_lock_free, "used in a signal handler");

/** Plain memory, since a signal handler may not touch a std::string. */
char temporary_files[32][4096];

void
handleSignal(int)
{
  if (!signal_came.exchange(true))
    return;
  for (const auto& path : temporary_files)
    if (path[0] != '\0')
      unlink(path);
  _exit(INTERRUPTED);
}

} // namespace

void
installInterruptHandlers()
{
  struct sigaction action {};
  action.sa_handler = handleSignal;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  struct sigaction before {};
  sigaction(SIGHUP, nullptr, &before);
  if (before.sa_handler != SIG_IGN) // else nohup wants the run to go on
    sigaction(SIGHUP, &action, nullptr);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  std::signal(SIGPIPE, SIG_IGN);
}

bool
interrupted()
{
  return signal_came.load();
}

int
addTemporaryFile(const std::string& path)
{
  int slot = 0;
  for (auto& free_slot : temporary_files) {
    if (free_slot[0] == '\0' && !path.empty() && path.size() < sizeof(free_slot)) {
      std::memcpy(free_slot + 1, path.c_str() + 1, path.size());
      free_slot[0] = path[0]; // last: from now on the name counts
      return slot;
    }
    ++slot;
  }
  return -1;
}

void
removeTemporaryFile(int slot)
{
  if (slot >= 0)
    temporary_files[slot][0] = '\0';
}

} // namespace app
