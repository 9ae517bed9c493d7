// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the bytes of an input file, mapped into memory.
#pragma once

#include "status.h"

#include <cstddef>
#include <string>
#include <vector>

namespace app {

/** \brief Read-only view of a whole file.
 *
 * Regular files are mapped, so that five million points cost no second copy; anything
 * else that can be read (a pipe) is read into memory. Knowing the length before parsing
 * lets each reader refuse counts that the file cannot hold before it takes memory.
 */
class InputFile {
public:
  InputFile() = default;
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile&
  operator=(const InputFile&) = delete;

  /** \brief Open \a path. Missing, unreadable and empty files and folders are errors.
   */
  Status
  open(const std::string& path);

  const char*
  begin() const
  {
    return data_;
  }
  const char*
  end() const
  {
    return data_ + size_;
  }
  std::size_t
  size() const
  {
    return size_;
  }

private:
  Status
  readAll(int descriptor, const std::string& path);

  const char* data_ = nullptr;
  std::size_t size_ = 0;
  bool mapped_ = false;
  std::vector<char> buffer_;
};

} // namespace app
