// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the fuzzer's bytes as a file that the programs read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace fuzz {

/** \brief A file with these bytes, gone with this object. */
class TemporaryFile {
public:
  TemporaryFile(const std::string& ending, const std::uint8_t* data, std::size_t size);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile&
  operator=(const TemporaryFile&) = delete;

  const std::string&
  path() const
  {
    return path_;
  }

private:
  std::string path_;
};

/** \brief The ending of the format that the first bytes look like; \a otherwise when
 * they look like none, so that a seed is just a file as it is. */
std::string
endingFor(const std::uint8_t* data, std::size_t size, const std::string& otherwise);

} // namespace fuzz
