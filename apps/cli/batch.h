// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: one run over many inputs.
#pragma once

#include "cli.h"
#include "file_names.h"
#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <string>

namespace app {

/** \brief What a run over many inputs has in common. */
struct Batch {
  std::string program;
  FileNames files;
  bool quiet = false;
  bool writes = true; /**< false: a dry run, which needs no folder */
};

/** \brief Work on one input, whose names have an output of its own; \a report is empty
 * and may be filled. */
using BatchWork = std::function<Outcome(const FileNames& one, nlohmann::json& report)>;

/** \brief Run \a work on one input after the other, on through those that fail, but not
 * after a signal. Each output has its input's name with the ending of the format, in
 * the folder. Tells on stderr what went wrong, and writes one report with a list
 * "files". Fails before the work for two inputs of one name, for standard input, for
 * a cloud that would be lost, and for a folder or a report that cannot be written.
 * \return the worst outcome. */
Outcome
runBatch(const Batch& batch, const BatchWork& work);

} // namespace app
