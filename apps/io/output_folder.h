// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: several output files that appear together or not at all.
#pragma once

#include "output_file.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace app {

/** \brief Files of one run, most of them in one folder. All are written under temporary
 * names; commit() gives them their own. Without it, after an error or a signal, no file
 * is left, and no folder either that was made for them. */
class OutputFolder {
public:
  OutputFolder() = default;
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder&
  operator=(const OutputFolder&) = delete;

  /** \brief Whether files could be written to a folder at \a path, which need not be
   * there as long as the folder above it is; done before long work. */
  static Status
  check(const std::string& path);

  /** \brief Whether \a file lies in the folder at \a path, which is yet to be made. */
  static bool
  bringsAlong(const std::string& path, const std::string& file);

  /** \brief Use the folder at \a path, made if missing. */
  Status
  open(const std::string& path);

  /** \brief Begin the file \a name in the folder. Valid as long as the folder; check
   * status() before use of what was written. */
  OutputFile&
  add(const std::string& name);

  /** \brief Begin a file anywhere that belongs to the run. */
  OutputFile&
  addElsewhere(const std::string& path);

  /** \brief A file of an earlier run that this one has nothing to put in: commit()
   * removes it, lest it be taken for a result of this one. */
  void
  drop(const std::string& name);

  /** \brief The first error so far. */
  const Status&
  status() const
  {
    return status_;
  }

  /** \brief Give all files their names. */
  Status
  commit();

private:
  std::string path_;
  std::string made_; /**< the folder, as long as it has to go after an error */
  std::vector<std::unique_ptr<OutputFile>> files_;
  std::vector<std::string> dropped_;
  Status status_;
};

} // namespace app
