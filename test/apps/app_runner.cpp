// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: runs the built programs as a user does.
#include "app_runner.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <thread>

extern char** environ; // NOLINT: POSIX

namespace app_test {

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder()
{
  std::string name = (fs::temp_directory_path() / "psr-apps-XXXXXX").string();
  if (mkdtemp(name.data()))
    folder_ = name;
}

TemporaryFolder::~TemporaryFolder()
{
  std::error_code ignored;
  if (!folder_.empty())
    fs::remove_all(folder_, ignored);
}

std::vector<std::string>
TemporaryFolder::names() const
{
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder_))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

namespace {

/** A started program whose stdin, stdout and stderr are three files. */
pid_t
start(const std::string& program,
      const std::vector<std::string>& arguments,
      const std::string& input,
      const std::string& output,
      const std::string& errors)
{
  const std::string path =
      program.front() == '/' ? program : std::string(PSR_APPS_DIR) + "/" + program;
  std::vector<char*> words{const_cast<char*>(path.c_str())};
  for (const std::string& argument : arguments)
    words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  const int flags = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_addopen(&actions, 0, input.c_str(), O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 1, output.c_str(), flags, 0600);
  posix_spawn_file_actions_addopen(&actions, 2, errors.c_str(), flags, 0600);
  pid_t child = -1;
  const int error =
      posix_spawn(&child, path.c_str(), &actions, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return error == 0 ? child : -1;
}

RunResult
run(const std::string& program,
    const std::vector<std::string>& arguments,
    const std::string& input,
    int delay_ms)
{
  const TemporaryFolder folder;
  const std::string output = folder.path("stdout");
  const std::string errors = folder.path("stderr");
  RunResult result;
  const pid_t child = start(program, arguments, input, output, errors);
  if (child < 0)
    return result;
  if (delay_ms >= 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(delay_ms));
    kill(child, SIGINT);
  }
  int state = 0;
  waitpid(child, &state, 0);
  result.exit_code = WIFEXITED(state) ? WEXITSTATUS(state) : -1;
  result.output = readFile(output);
  result.errors = readFile(errors);
  return result;
}

} // namespace

RunResult
runApp(const std::string& program,
       std::vector<std::string> arguments,
       const std::vector<std::string>& more)
{
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run(program, arguments, "/dev/null", -1);
}

RunResult
runWithInput(const std::string& program,
             const std::vector<std::string>& arguments,
             const std::string& input)
{
  return run(program, arguments, input, -1);
}

RunResult
runInShell(const std::string& commands)
{
  return run("/bin/bash",
             {"-c", "set -o pipefail; PATH=" PSR_APPS_DIR ":$PATH; " + commands},
             "/dev/null",
             -1);
}

RunResult
runAndInterrupt(const std::string& program,
                const std::vector<std::string>& arguments,
                int delay_ms)
{
  return run(program, arguments, "/dev/null", delay_ms);
}

std::string
readFile(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

void
writeFile(const std::string& path, const std::string& bytes)
{
  std::ofstream file(path, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

bool
isOneLineWithVerdict(const std::string& text)
{
  const std::size_t verdict = text.find('\n') + 1;
  return isOneLine(text.substr(0, verdict)) && isOneLine(text.substr(verdict)) &&
         text.substr(verdict).find("complete: ") != std::string::npos;
}

bool
isOneLine(const std::string& text)
{
  return text.size() > 1 && text.find('\n') == text.size() - 1;
}

} // namespace app_test
