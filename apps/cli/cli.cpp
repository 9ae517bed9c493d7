// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the course of every app.
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

/** The last line of a run that came to its end. */
void
tellVerdict(const Outcome& outcome)
{
  if (outcome.verdict.people != nullptr && !outcome.verdict.facts.empty())
    *outcome.verdict.people << (outcome.code == DONE ? "complete: " : "incomplete: ")
                            << onOneLine(outcome.verdict.facts) << std::endl;
}

[[noreturn]] void
failAboutSame(const std::string& first, const std::string& second)
{
  throw Failure("'" + first + "' and '" + second +
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

void
checkDifferentPaths(const std::vector<std::string>& paths)
{
  std::map<std::string, std::string> by_name;
  std::map<std::pair<dev_t, ino_t>, std::string> by_number;
  for (const std::string& path : paths) {
    const Identity identity = identityOf(path);
    const auto [named, is_new_name] = by_name.emplace(identity.canonical, path);
    if (!is_new_name)
      failAboutSame(named->second, path);
    if (identity.number == 0)
      continue;
    const auto [numbered, is_new_number] =
        by_number.emplace(std::pair(identity.device, identity.number), path);
    if (!is_new_number)
      failAboutSame(numbered->second, path);
  }
}

} // namespace

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
  if (outcome.succeeded() && !quiet)
    for (const std::string& note : outcome.notes)
      complain(who, "note: " + note);
  if (outcome.code != DONE)
    complain(who, outcome.reason);
}

int
runApp(CommandLine& command_line,
       int argc,
       const char* const* argv,
       const std::function<Outcome()>& body)
{
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  installInterruptHandlers();
  const std::string& program = command_line.program();
  try {
    command_line.parse(argc, argv);
  }
  catch (const Failure& failure) {
    complain(program, failure.what());
    return BAD_INPUT;
  }
  if (command_line.given("help"))
    return answer(program, command_line.help());
  if (command_line.given("version"))
    return answer(program, program + " " + version() + "\n");
  allowLosingClouds(command_line.given("force"));
  Outcome outcome = runGuarded(body);
  if (interrupted() && outcome.code == BAD_INPUT)
    outcome = {INTERRUPTED, stopped_by_signal, {}};
  const bool quiet = command_line.given("quiet");
  tellOutcome(program, outcome, quiet);
  if (outcome.succeeded() && !quiet)
    tellVerdict(outcome);
  // A reader that has seen enough of the summary (head) is no failure.
  if (flushedStandardOutput() || errno == EPIPE || !outcome.succeeded())
    return outcome.code;
  complain(program, "cannot write to standard output: " + lastError());
  return INCOMPLETE;
}

std::ostream&
peopleStream(const std::vector<std::string>& outputs)
{
  const bool is_taken = std::any_of(outputs.begin(), outputs.end(), isStandardStream);
  return is_taken ? std::cerr : std::cout;
}

void
checkDifferentFiles(const std::vector<std::string>& inputs,
                    const std::vector<std::string>& outputs)
{
  if (std::count(inputs.begin(), inputs.end(), standard_stream) > 1)
    throw Failure("standard input ('-') can be read once only");
  if (std::count(outputs.begin(), outputs.end(), standard_stream) > 1)
    throw Failure("standard output ('-') can take one output only");
  std::vector<std::string> paths(inputs);
  paths.insert(paths.end(), outputs.begin(), outputs.end());
  paths.erase(std::remove_if(paths.begin(),
                             paths.end(),
                             [](const std::string& path) {
                               return path.empty() || isStandardStream(path);
                             }),
              paths.end());
  checkDifferentPaths(paths);
}

} // namespace app
