// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which names on the command line are inputs, and which the
// output.
#pragma once

#include "command_line.h"
#include "io/model_io.h"

#include <string>
#include <vector>

namespace app {

/** \brief Files of a program that reads one or several and writes one, or one of each.
 */
struct FileNames {
  std::vector<std::string> inputs;
  std::string output; /**< empty: none */
  std::string folder; /**< for an output of each input; empty: none */
  std::string report; /**< empty: none */
  FileFormat format = FileFormat::UNKNOWN; /**< where no name tells it */

  const std::string&
  input() const
  {
    return inputs.front();
  }

  /** \brief Whether each input gets an output of its own. */
  bool
  isBatch() const
  {
    return !folder.empty();
  }

  /** \brief Where the output goes; of a batch, one without a name. */
  Target
  target() const;
};

/** \brief How a program calls its names, and what it makes of several. */
struct FileRules {
  const char* input;  /**< the argument, in capitals */
  const char* output; /**< the same */
  const char* remedy; /**< what several inputs need */
  const bool* merges; /**< whether several inputs make one output; null: never */
  const std::string* instead = nullptr; /**< unless empty, they need none */
};

/** \brief Add --output and --output-folder, the arguments of \a rules, and any number
 * of further ones. Where --output or --output-folder is given, all names without a dash
 * are inputs; else there may be one and the output. Of more names none may be the
 * output, nor of two that are merged: it could be the last of a list of scans. */
void
addFileNames(CommandLine& command_line, const FileRules& rules, FileNames& names);

/** \brief Add --format, which stays UNKNOWN unless it is given; \a list says what may
 * be given. Refused when each output has an ending of its own, and a format that is not
 * known. */
void
addFormatOption(CommandLine& command_line,
                const std::string& list,
                FileFormat& format,
                std::function<bool()> is_needed);

/** \brief The same for \a names, whose outputs are meshes: those of a batch are PLY
 * unless it is given. \a what the outputs are for */
void
addFormatOption(CommandLine& command_line, FileNames& names, const std::string& what);

/** \brief A named file in the format of its ending, "-" in \a format, or PLY. */
Target
makeTarget(const std::string& path, FileFormat format);

/** \brief Name of an input or output in the summary of a run. */
std::string
summaryName(const std::string& path, const char* stream = "standard output");

} // namespace app
