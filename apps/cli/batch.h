// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: one program run over many inputs.
#pragma once

#include "cli.h"
#include "io/file_format.h"
#include "run_facts.h"
#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <string>
#include <vector>

namespace app {

/** \brief One input and where its result goes. */
struct BatchItem {
  std::string input;
  std::string output;
};

/** \brief What a run over many inputs has in common. */
struct BatchSettings {
  std::string program;
  std::vector<std::string> inputs;
  std::string folder; /**< of the outputs; made if missing */
  std::string report; /**< empty: none */
  FileFormat format = FileFormat::PLY;
  bool quiet = false;
  bool writes = true; /**< false: a dry run, which needs no folder */
};

/** \brief Work on one input; \a report is empty and may be filled. */
using BatchWork = std::function<Outcome(const BatchItem& item, nlohmann::json& report)>;

/** \brief Run \a work on one input after the other, on through those that fail, but not
 * after a signal. Each output has its input's name with the ending of the format, in
 * the folder. Tells on stderr what went wrong, and writes one report with a list
 * "files". Fails before the work for two inputs of one name, for standard input, for
 * a cloud that would be lost, and for a folder or a report that cannot be written.
 * \return the worst outcome. */
Outcome
runBatch(const BatchSettings& settings, const BatchWork& work);

} // namespace app
