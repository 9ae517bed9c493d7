// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the command line and the course of every app.
#include "cli.h"

#include <pcl/console/print.h>

#include "interrupt.h"

#include <cstdio>
#include <filesystem>
#include <iostream>
#include <new>
#include <sstream>

#ifndef PSR_VERSION
#define PSR_VERSION "of an unknown version"
#endif

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

/** The body's outcome; what it or a library throws becomes an outcome, too. */
Outcome
runGuarded(const Arguments& arguments,
           const std::function<Outcome(const Arguments&)>& body)
{
  try {
    return body(arguments);
  }
  catch (const std::bad_alloc&) {
    return {BAD_INPUT, "not enough memory for this input", {}};
  }
  catch (const std::exception& error) {
    return {BAD_INPUT, error.what(), {}};
  }
}

bool
flushedStandardOutput()
{
  std::cout.flush();
  return std::cout.good() && std::fflush(stdout) == 0;
}

int
answer(const std::string& text)
{
  std::cout << text;
  return flushedStandardOutput() ? DONE : BAD_INPUT;
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

} // namespace

CommandLine::CommandLine(Usage usage)
: usage_(std::move(usage)), options_("Options", 88, 50)
{
  options_.add_options()("help,h", "print this text and stop")(
      "version", "print the version and stop")(
      "quiet,q", "print nothing but errors: no progress, no summary, no notes");
}

void
CommandLine::addPositional(const std::string& name)
{
  addOptionalPositional(name);
  required_.push_back(name);
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
    all.add(options_).add(hidden_);
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
  text
      << "Usage: " << usage_.program << " " << usage_.synopsis << "\n\n"
      << usage_.summary << "\n\n"
      << options_ << "\nExamples:\n"
      << usage_.examples
      << "\nExit codes: 0 done; 1 bad usage or bad input, nothing written; 2 done, but "
         "something\nwas left undone (stderr says what); 130 stopped by Ctrl-C.\n";
  return text.str();
}

int
runApp(const CommandLine& command_line,
       int argc,
       const char* const* argv,
       const std::function<Outcome(const Arguments&)>& body)
{
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  Arguments arguments;
  const Status status = command_line.parse(argc, argv, arguments);
  if (!status.ok()) {
    complain(command_line.program(), status.message());
    return BAD_INPUT;
  }
  if (arguments.count("help") != 0)
    return answer(command_line.help());
  if (arguments.count("version") != 0)
    return answer(command_line.program() + " " PSR_VERSION "\n");
  installInterruptHandlers();
  Outcome outcome = runGuarded(arguments, body);
  if (interrupted() && outcome.code == BAD_INPUT)
    outcome = {INTERRUPTED, "stopped by a signal; nothing was written", {}};
  const bool succeeded = outcome.code == DONE || outcome.code == INCOMPLETE;
  if (succeeded && arguments.count("quiet") == 0)
    for (const std::string& note : outcome.notes)
      complain(command_line.program(), "note: " + note);
  if (outcome.code != DONE)
    complain(command_line.program(), outcome.reason);
  flushedStandardOutput();
  return outcome.code;
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

Status
checkDifferentFiles(const std::vector<std::string>& paths)
{
  namespace fs = std::filesystem;
  for (std::size_t i = 0; i < paths.size(); ++i)
    for (std::size_t j = i + 1; j < paths.size(); ++j) {
      if (paths[i].empty() || paths[j].empty())
        continue;
      std::error_code error;
      const fs::path first = fs::weakly_canonical(paths[i], error);
      const fs::path second = fs::weakly_canonical(paths[j], error);
      const bool same_place = fs::equivalent(paths[i], paths[j], error) && !error;
      if (first == second || same_place)
        return Status::error("'" + paths[i] + "' and '" + paths[j] +
                             "' are the same file; give each its own name");
    }
  return {};
}

} // namespace app
