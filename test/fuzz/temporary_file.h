// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a place for the files that a fuzz target writes.
#pragma once

#include <string>

namespace fuzz {

/** \brief The name of a file that is gone with this object. */
class TemporaryFile {
public:
  explicit TemporaryFile(const std::string& ending);
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

} // namespace fuzz
