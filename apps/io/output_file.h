// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: an output file that is either whole or not there.
#pragma once

#include "status.h"

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace app {

/** \brief Writes to a temporary name in the folder of the target; commit() renames it.
 * Without commit(), after an error or a signal, the temporary file is removed, and a
 * target of an earlier run stays as it was. A cloud of others is not replaced, see
 * checkReplaceable(). Devices and pipes are written directly.
 * Standard output ("-") gets its first byte in commit(). */
class OutputFile {
public:
  OutputFile() = default;
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile&
  operator=(const OutputFile&) = delete;

  /** \brief Whether \a path could be written now; done before long work. */
  static Status
  check(const std::string& path);

  Status
  open(const std::string& path);

  /** \brief Append bytes. Errors are kept until commit(). */
  void
  write(const void* bytes, std::size_t count);

  void
  text(std::string_view words)
  {
    write(words.data(), words.size());
  }

  /** \brief Append a number in as few digits as read back exactly. */
  template <typename T>
  void
  number(T value)
  {
    char digits[64];
    const auto end = std::to_chars(digits, digits + sizeof(digits), value).ptr;
    write(digits, static_cast<std::size_t>(end - digits));
  }

  /** \brief Append a whole number or real with its bytes reversed, as legacy VTK wants.
   */
  template <typename T>
  void
  bigEndian(T value)
  {
    const auto* bytes = reinterpret_cast<const char*>(&value);
    char reversed[sizeof(T)];
    for (std::size_t i = 0; i < sizeof(T); ++i)
      reversed[i] = bytes[sizeof(T) - 1 - i];
    write(reversed, sizeof(T));
  }

  /** \brief Whether it is standard output, which nobody can take back: to be committed
   * when all else is known to work. */
  bool
  isStandardOutput() const
  {
    return is_stream_;
  }

  /** \brief Write the rest: all that can fail for lack of room. Nothing may be appended
   * any more. */
  Status
  finish();

  /** \brief Write the rest and give the file its name. */
  Status
  commit();

private:
  void
  flush();
  Status
  commitStream();
  void
  discard();

  std::string path_;
  std::string temporary_;
  int slot_ = -1; /**< of the temporary file, see addTemporaryFile() */
  int descriptor_ = -1;
  int error_ = 0;
  bool is_stream_ = false;
  std::vector<char> buffer_;
  std::vector<std::vector<char>> held_back_; /**< for standard output */
};

} // namespace app
