// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a place for the files that a fuzz target writes.
#include "temporary_file.h"

#include <unistd.h>

#include <filesystem>

namespace fuzz {
namespace {

/** In memory where there is such a place: a fuzzer writes thousands a second. */
std::string
folder()
{
  const char* const shared_memory = "/dev/shm";
  return access(shared_memory, W_OK) == 0
             ? shared_memory
             : std::filesystem::temp_directory_path().string();
}

} // namespace

TemporaryFile::TemporaryFile(const std::string& ending)
: path_(folder() + "/psr_fuzz_" + std::to_string(getpid()) + ending)
{}

TemporaryFile::~TemporaryFile() { unlink(path_.c_str()); }

} // namespace fuzz
