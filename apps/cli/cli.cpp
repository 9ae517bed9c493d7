// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the command line and the course of every app.
#include "cli.h"

#include <pcl/console/print.h>

#include "io/file_format.h"
#include "io/interrupt.h"
#include "io/overwriting.h"
#include "run_facts.h"
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <map>
#include <new>
#include <sstream>

namespace app {
namespace {

namespace po = boost::program_options;

/** File names and file contents in a message must not break its one line. */
std::string
onOneLine(std::string text)
{
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f')
      c = '?';
  return text;
}

void
complain(const std::string& program, const std::string& reason)
{
  std::cerr << program << ": " << onOneLine(reason) << std::endl;
}

std::string
lastError()
{
  return errno == 0 ? "the reason is not known" : std::strerror(errno);
}

bool
flushedStandardOutput()
{
  std::cout.flush();
  return std::cout.good() && std::fflush(stdout) == 0;
}

int
answer(const std::string& program, const std::string& text)
{
  std::cout << text;
  if (flushedStandardOutput())
    return DONE;
  complain(program, "cannot write to standard output: " + lastError());
  return BAD_INPUT;
}

template <typename T>
Status
takeBetween(
    const Arguments& arguments, const std::string& name, T lowest, T highest, T& value)
{
  if (arguments.count(name) == 0)
    return {};
  value = arguments[name].as<T>();
  if (value >= lowest && value <= highest)
    return {};
  std::ostringstream text;
  text << "--" << name << " must be from " << lowest << " to " << highest << ", not "
       << value;
  return Status::error(text.str());
}

Status
sameFile(const std::string& first, const std::string& second)
{
  return Status::error("'" + first + "' and '" + second +
                       "' are the same file; give each its own name");
}

/** What tells whether two names stand for one file. */
struct Identity {
  std::string canonical;
  dev_t device = 0;
  ino_t number = 0; // 0: there is no file yet
};

Identity
identityOf(const std::string& path)
{
  std::error_code error;
  Identity identity;
  identity.canonical = std::filesystem::weakly_canonical(path, error).string();
  struct stat info {};
  if (stat(path.c_str(), &info) == 0) {
    identity.device = info.st_dev;
    identity.number = info.st_ino;
  }
  return identity;
}

Status
checkDifferentPaths(const std::vector<std::string>& paths)
{
  std::map<std::string, std::string> by_name;
  std::map<std::pair<dev_t, ino_t>, std::string> by_number;
  for (const std::string& path : paths) {
    const Identity identity = identityOf(path);
    const auto [named, is_new_name] = by_name.emplace(identity.canonical, path);
    if (!is_new_name)
      return sameFile(named->second, path);
    if (identity.number == 0)
      continue;
    const auto [numbered, is_new_number] =
        by_number.emplace(std::pair(identity.device, identity.number), path);
    if (!is_new_number)
      return sameFile(numbered->second, path);
  }
  return {};
}

} // namespace

CommandLine::CommandLine(Usage usage)
: usage_(std::move(usage))
, options_("Options", 88, 50)
, method_options_("Options of the method, whose defaults fit nearly always", 88, 50)
{
  options_.add_options()("help,h", "print this text and stop")(
      "version", "print the version and stop")(
      "quiet,q", "print nothing but errors: no progress, no summary, no notes")(
      "force",
      "write over files that hold points without triangles and were not written by "
      "these programs, such as scans; refused otherwise");
}

void
CommandLine::addPositional(const std::string& name)
{
  addOptionalPositional(name);
  required_.push_back(name);
}

void
CommandLine::addMorePositionals(const std::string& name)
{
  hidden_.add_options()(name.c_str(), po::value<std::vector<std::string>>());
  positional_.add(name.c_str(), -1);
}

void
CommandLine::addOptionalPositional(const std::string& name)
{
  hidden_.add_options()(name.c_str(), po::value<std::string>());
  positional_.add(name.c_str(), 1);
}

Status
CommandLine::parse(int argc, const char* const* argv, Arguments& arguments) const
{
  try {
    po::options_description all;
    all.add(options_).add(method_options_).add(hidden_);
    const int style =
        po::command_line_style::unix_style & ~po::command_line_style::allow_guessing;
    po::command_line_parser parser(argc, argv);
    po::store(parser.options(all).positional(positional_).style(style).run(),
              arguments);
  }
  catch (const po::error& error) {
    return Status::error(std::string(error.what()) + " (try --help)");
  }
  if (arguments.count("help") != 0 || arguments.count("version") != 0)
    return {};
  for (const std::string& name : required_)
    if (arguments.count(name) == 0)
      return Status::error(name + " is missing (try --help)");
  return {};
}

std::string
CommandLine::help() const
{
  std::ostringstream text;
  text << "Usage: " << usage_.program << " " << usage_.synopsis << "\n\n"
       << usage_.summary << "\n\n"
       << options_ << "\n";
  if (!method_options_.options().empty())
    text << method_options_ << "\n";
  text
      << "Examples:\n"
      << usage_.examples
      << "\nExit codes: 0 done; 1 bad usage or bad input, nothing written; 2 done, but "
         "something\nwas left undone (stderr says what); 130 stopped by Ctrl-C.\n";
  return text.str();
}

Outcome
runGuarded(const std::function<Outcome()>& work)
{
  try {
    return work();
  }
  catch (const std::bad_alloc&) {
    return {BAD_INPUT, "not enough memory for this input", {}};
  }
  catch (const std::exception& error) {
    return {BAD_INPUT, error.what(), {}};
  }
}

void
tellOutcome(const std::string& who, const Outcome& outcome, bool quiet)
{
  const bool succeeded = outcome.code == DONE || outcome.code == INCOMPLETE;
  if (succeeded && !quiet)
    for (const std::string& note : outcome.notes)
      complain(who, "note: " + note);
  if (outcome.code != DONE)
    complain(who, outcome.reason);
}

namespace {

/** The last line of a run that came to its end. */
void
tellVerdict(const Outcome& outcome)
{
  if (outcome.verdict.people != nullptr && !outcome.verdict.facts.empty())
    *outcome.verdict.people << (outcome.code == DONE ? "complete: " : "incomplete: ")
                            << onOneLine(outcome.verdict.facts) << std::endl;
}

} // namespace

int
runApp(const CommandLine& command_line,
       int argc,
       const char* const* argv,
       const std::function<Outcome(const Arguments&)>& body)
{
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  installInterruptHandlers();
  Arguments arguments;
  const Status status = command_line.parse(argc, argv, arguments);
  if (!status.ok()) {
    complain(command_line.program(), status.message());
    return BAD_INPUT;
  }
  if (arguments.count("help") != 0)
    return answer(command_line.program(), command_line.help());
  if (arguments.count("version") != 0)
    return answer(command_line.program(),
                  command_line.program() + " " + version() + "\n");
  allowLosingClouds(arguments.count("force") != 0);
  Outcome outcome = runGuarded([&] { return body(arguments); });
  if (interrupted() && outcome.code == BAD_INPUT)
    outcome = {INTERRUPTED, stopped_by_signal, {}};
  const bool succeeded = outcome.code == DONE || outcome.code == INCOMPLETE;
  const bool quiet = arguments.count("quiet") != 0;
  tellOutcome(command_line.program(), outcome, quiet);
  if (succeeded && !quiet)
    tellVerdict(outcome);
  // A reader that has seen enough of the summary (head) is no failure.
  if (flushedStandardOutput() || errno == EPIPE || !succeeded)
    return outcome.code;
  complain(command_line.program(), "cannot write to standard output: " + lastError());
  return INCOMPLETE;
}

Status
takeCount(const Arguments& arguments,
          const std::string& name,
          long long lowest,
          long long highest,
          unsigned int& value)
{
  long long number = value;
  const Status status = takeBetween(arguments, name, lowest, highest, number);
  if (status.ok())
    value = static_cast<unsigned int>(number);
  return status;
}

Status
takeReal(const Arguments& arguments,
         const std::string& name,
         double lowest,
         double highest,
         double& value)
{
  return takeBetween(arguments, name, lowest, highest, value);
}

po::typed_value<double>*
realValue(double default_value)
{
  std::ostringstream text;
  text << default_value;
  return po::value<double>()->default_value(default_value, text.str());
}

std::string
takeText(const Arguments& arguments, const std::string& name)
{
  return arguments.count(name) == 0 ? "" : arguments[name].as<std::string>();
}

std::vector<std::string>
takeTexts(const Arguments& arguments, const std::string& name)
{
  return arguments.count(name) == 0 ? std::vector<std::string>()
                                    : arguments[name].as<std::vector<std::string>>();
}

std::ostream&
peopleStream(const std::vector<std::string>& outputs)
{
  const bool is_taken = std::any_of(outputs.begin(), outputs.end(), isStandardStream);
  return is_taken ? std::cerr : std::cout;
}

Status
checkDifferentFiles(const std::vector<std::string>& inputs,
                    const std::vector<std::string>& outputs)
{
  if (std::count(inputs.begin(), inputs.end(), standard_stream) > 1)
    return Status::error("standard input ('-') can be read once only");
  if (std::count(outputs.begin(), outputs.end(), standard_stream) > 1)
    return Status::error("standard output ('-') can take one output only");
  std::vector<std::string> paths(inputs);
  paths.insert(paths.end(), outputs.begin(), outputs.end());
  paths.erase(std::remove_if(paths.begin(),
                             paths.end(),
                             [](const std::string& path) {
                               return path.empty() || isStandardStream(path);
                             }),
              paths.end());
  return checkDifferentPaths(paths);
}

} // namespace app
