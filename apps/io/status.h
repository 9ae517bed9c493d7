// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how the parts of an app say that something went wrong.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace app {

/** \brief Exit codes of all apps. */
enum ExitCode {
  DONE = 0,       /**< everything asked for was done */
  BAD_INPUT = 1,  /**< bad usage or bad input; nothing was written */
  INCOMPLETE = 2, /**< output written, but something was left undone; stderr says why */
  INTERRUPTED = 130 /**< stopped by a signal; nothing was written */
};

/** \brief Success, or one sentence a user can act on. What has to do with files tells
 * how it went in this way, since its caller may go on all the same; all else throws a
 * Failure. */
class [[nodiscard]] Status {
public:
  Status() = default;

  static Status
  error(std::string message)
  {
    Status status;
    status.ok_ = false;
    status.message_ = std::move(message);
    return status;
  }

  bool
  ok() const
  {
    return ok_;
  }

  const std::string&
  message() const
  {
    return message_;
  }

private:
  bool ok_ = true;
  std::string message_;
};

/** \brief One sentence a user can act on. Ends a reader, or, by runGuarded(), a run. */
class Failure : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/** \brief Throws a Failure with the message of a failed status. */
inline void
require(const Status& status)
{
  if (!status.ok())
    throw Failure(status.message());
}

/** \brief Sentences about what was done differently from what the user may expect. */
using Warnings = std::vector<std::string>;

} // namespace app
