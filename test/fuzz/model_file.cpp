// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the fuzzer's bytes as a file that the programs read.
#include "model_file.h"

#include "requirement.h"
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string_view>

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

TemporaryFile::TemporaryFile(const std::string& ending,
                             const std::uint8_t* data,
                             std::size_t size)
: path_(folder() + "/psr_fuzz_" + std::to_string(getpid()) + ending)
{
  std::ofstream file(path_, std::ios::binary | std::ios::trunc);
  file.write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  file.close();
  require(file.good(), "the temporary file can be written");
}

TemporaryFile::~TemporaryFile() { unlink(path_.c_str()); }

std::string
endingFor(const std::uint8_t* data, std::size_t size, const std::string& otherwise)
{
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto begins = [&](std::string_view word) {
    return text.substr(0, word.size()) == word;
  };
  if (begins("ply"))
    return ".ply";
  if (begins("# vtk"))
    return ".vtk";
  if (begins("OFF") || begins("COFF") || begins("NOFF"))
    return ".off";
  if (begins("solid"))
    return ".stl";
  if (begins("# .PCD") || begins("VERSION"))
    return ".pcd";
  if (begins("v ") || begins("#obj"))
    return ".obj";
  return otherwise;
}

} // namespace fuzz
