// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the bytes of an input file, mapped into memory.
#pragma once

#include "status.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace app {

/** \brief Read-only view of a whole file.
 *
 * Regular files are mapped, so that five million points cost no second copy; anything
 * else that can be read (a pipe, standard input) is read into memory. Knowing the
 * length before parsing lets each reader refuse counts that the file cannot hold before
 * it takes memory.
 */
class InputFile {
public:
  InputFile() = default;
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile&
  operator=(const InputFile&) = delete;

  /** \brief A file of \a size bytes that are in memory already, and stay there. */
  InputFile(const char* bytes, std::size_t size) : data_(bytes), size_(size) {}

  /** \brief Open \a path, or standard input for "-". Missing, unreadable and empty
   * files and folders are errors, and so is a signal while a pipe is waited for. */
  Status
  open(const std::string& path);

  /** \brief Leave out the first bytes. */
  void
  skip(std::size_t bytes)
  {
    skipped_ += bytes < size() ? bytes : size();
  }

  /** \brief Whether it is not in memory of its own. */
  bool
  isMapped() const
  {
    return mapped_;
  }

  const char*
  begin() const
  {
    return data_ + skipped_;
  }
  const char*
  end() const
  {
    return data_ + size_;
  }
  std::size_t
  size() const
  {
    return size_ - skipped_;
  }
  std::string_view
  bytes() const
  {
    return {begin(), size()};
  }

private:
  Status
  openNamed(const std::string& path);
  Status
  readAll(int descriptor, const std::string& name);

  const char* data_ = nullptr;
  std::size_t size_ = 0;
  std::size_t skipped_ = 0;
  bool mapped_ = false;
  std::vector<char> buffer_;
};

} // namespace app
