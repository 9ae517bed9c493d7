// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the course of every app.
#pragma once

#include "command_line.h"

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace app {

/** \brief The sentence for the code INTERRUPTED. */
constexpr const char* stopped_by_signal = "stopped by a signal; nothing was written";

/** \brief The last line of a run, which begins with "complete" or "incomplete". */
struct Verdict {
  std::string facts;              /**< what follows that; empty: no line */
  std::ostream* people = nullptr; /**< where it goes, see peopleStream() */
};

/** \brief How a run ended. */
struct Outcome {
  ExitCode code = DONE;
  std::string reason; /**< one sentence for stderr unless the code is DONE */
  Warnings notes;     /**< printed to stderr after success, unless quiet */
  Verdict verdict = {};

  bool
  succeeded() const
  {
    return code == DONE || code == INCOMPLETE;
  }
};

/** \brief Whole course of an app: parse, answer --help and --version, run \a body with
 * signals caught and PCL's console silent, print its outcome and, unless quiet, its
 * verdict, return the exit code. */
int
runApp(CommandLine& command_line,
       int argc,
       const char* const* argv,
       const std::function<Outcome()>& body);

/** \brief The outcome of \a work; what it or a library throws is bad input, and so is
 * running out of memory. */
Outcome
runGuarded(const std::function<Outcome()>& work);

/** \brief Print the notes of a success, unless \a quiet, and the reason of anything
 * else, after \a who. */
void
tellOutcome(const std::string& who, const Outcome& outcome, bool quiet);

/** \brief What is for people goes to standard output, unless one of \a outputs does
 * ("-"): then to standard error. */
std::ostream&
peopleStream(const std::vector<std::string>& outputs);

/** \brief Fails when two of the given files are the same one; empty names are none. "-"
 * may stand for standard input once and for standard output once. */
void
checkDifferentFiles(const std::vector<std::string>& inputs,
                    const std::vector<std::string>& outputs);

} // namespace app
