// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: runs the built programs as a user does.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace app_test {

/** \brief A folder of its own for one test, removed with all that is in it. */
class TemporaryFolder {
public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder&
  operator=(const TemporaryFolder&) = delete;

  /** \brief Path of a file of this name in the folder. */
  std::string
  path(const std::string& name) const
  {
    return (folder_ / name).string();
  }

  /** \brief Names of all files in the folder, sorted. */
  std::vector<std::string>
  names() const;

private:
  std::filesystem::path folder_;
};

/** \brief What a finished program left behind. */
struct RunResult {
  int exit_code = -1; /**< -1: it crashed */
  std::string output; /**< stdout */
  std::string errors; /**< stderr */
};

/** \brief Run a program of ours with these arguments, and more, and wait for it. */
RunResult
runApp(const std::string& program,
       std::vector<std::string> arguments,
       const std::vector<std::string>& more = {});

/** \brief The same with a file as standard input. */
RunResult
runWithInput(const std::string& program,
             const std::vector<std::string>& arguments,
             const std::string& input);

/** \brief Commands of bash, which finds our programs by their names. */
RunResult
runInShell(const std::string& commands);

/** \brief As runApp(), with SIGINT sent `delay_ms` after the start. */
RunResult
runAndInterrupt(const std::string& program,
                const std::vector<std::string>& arguments,
                int delay_ms);

std::string
readFile(const std::string& path);

void
writeFile(const std::string& path, const std::string& bytes);

/** \brief Whether \a text is one line of figures and the verdict of a run. */
bool
isOneLineWithVerdict(const std::string& text);

/** \brief Whether \a text is one line: not empty, ending with its only line end. */
bool
isOneLine(const std::string& text);

} // namespace app_test
