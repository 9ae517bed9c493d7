// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: runs a fuzz target on given files, for compilers without
// libFuzzer and for files that once were a finding.
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <vector>

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

namespace fs = std::filesystem;

/** Files, and those in folders, in an order that is the same everywhere. */
std::set<fs::path>
listFiles(int argc, char** argv)
{
  std::set<fs::path> files;
  for (int i = 1; i < argc; ++i)
    if (fs::is_directory(argv[i]))
      for (const auto& entry : fs::directory_iterator(argv[i]))
        files.insert(entry.path());
    else
      files.insert(argv[i]);
  return files;
}

int
replay(int argc, char** argv)
{
  const auto files = listFiles(argc, argv);
  for (const fs::path& file : files) {
    std::ifstream stream(file, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), {}};
    std::fprintf(stderr, "%s\n", file.c_str());
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()),
                           bytes.size());
  }
  std::printf("%zu files without a finding\n", files.size());
  return files.empty() ? 1 : 0;
}

} // namespace

int
main(int argc, char** argv)
{
  try {
    return replay(argc, argv);
  }
  catch (const std::exception& problem) {
    std::fprintf(stderr, "finding: %s\n", problem.what());
    return 1;
  }
}
