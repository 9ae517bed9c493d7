// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the command line and the course of every app.
#pragma once

#include <boost/program_options.hpp>

#include "io/status.h"

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace app {

/** \brief What the usage text says besides the options. */
struct Usage {
  std::string program;
  std::string synopsis; /**< what follows the program's name on the first line */
  std::string summary;  /**< what the program does, in a few lines */
  std::string examples; /**< lines a newcomer can copy */
};

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

  /** \brief BAD_INPUT with the message of a failed status. */
  static Outcome
  badInput(const Status& status)
  {
    return {BAD_INPUT, status.message(), {}};
  }
};

using Arguments = boost::program_options::variables_map;

/** \brief Options of one app; --help, --version, --quiet and --force are there from the
 * start. */
class CommandLine {
public:
  explicit CommandLine(Usage usage);

  /** \brief To add options as Boost.Program_options does. */
  boost::program_options::options_description_easy_init
  addOptions()
  {
    return options_.add_options();
  }

  /** \brief The same for parameters of the method, which the help has behind all
   * others. */
  boost::program_options::options_description_easy_init
  addMethodOptions()
  {
    return method_options_.add_options();
  }

  /** \brief A required argument without a dash; \a name in capitals. */
  void
  addPositional(const std::string& name);

  /** \brief The same, but it may be left out. */
  void
  addOptionalPositional(const std::string& name);

  /** \brief Any number of further ones. */
  void
  addMorePositionals(const std::string& name);

  /** \brief Parse the arguments; abbreviations and unknown options are refused. */
  Status
  parse(int argc, const char* const* argv, Arguments& arguments) const;

  std::string
  help() const;

  const std::string&
  program() const
  {
    return usage_.program;
  }

private:
  Usage usage_;
  boost::program_options::options_description options_;
  boost::program_options::options_description method_options_;
  boost::program_options::options_description hidden_;
  boost::program_options::positional_options_description positional_;
  std::vector<std::string> required_;
};

/** \brief Whole course of an app: parse, answer --help and --version, run \a body with
 * signals caught and PCL's console silent, print its outcome and, unless quiet, its
 * verdict, return the exit code.
 * Running out of memory ends like bad input. */
int
runApp(const CommandLine& command_line,
       int argc,
       const char* const* argv,
       const std::function<Outcome(const Arguments&)>& body);

/** \brief The outcome of \a work; what it or a library throws becomes one, too. */
Outcome
runGuarded(const std::function<Outcome()>& work);

/** \brief Print the notes of a success, unless \a quiet, and the reason of anything
 * else, after \a who. */
void
tellOutcome(const std::string& who, const Outcome& outcome, bool quiet);

/** \brief Take a whole number from \a lowest to \a highest; the option has a default or
 * \a value stays as it is. */
Status
takeCount(const Arguments& arguments,
          const std::string& name,
          long long lowest,
          long long highest,
          unsigned int& value);

/** \brief Take a real number from \a lowest to \a highest. */
Status
takeReal(const Arguments& arguments,
         const std::string& name,
         double lowest,
         double highest,
         double& value);

/** \brief An option with a real number whose default is shown in few digits. */
boost::program_options::typed_value<double>*
realValue(double default_value);

/** \brief Take a text; empty if the option is not given. */
std::string
takeText(const Arguments& arguments, const std::string& name);

/** \brief Take the texts of an option that may come several times. */
std::vector<std::string>
takeTexts(const Arguments& arguments, const std::string& name);

/** \brief What is for people goes to standard output, unless one of \a outputs does
 * ("-"): then to standard error. */
std::ostream&
peopleStream(const std::vector<std::string>& outputs);

/** \brief Fails when two of the given files are the same one; empty names are none. "-"
 * may stand for standard input once and for standard output once. */
Status
checkDifferentFiles(const std::vector<std::string>& inputs,
                    const std::vector<std::string>& outputs);

} // namespace app
