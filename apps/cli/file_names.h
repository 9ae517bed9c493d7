// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which names on the command line are inputs, and which the
// output.
#pragma once

#include "cli.h"

#include <string>
#include <vector>

namespace app {

/** \brief Files of a program that reads one or several and writes one, or one of each.
 */
struct FileNames {
  std::vector<std::string> inputs;
  std::string output; /**< empty: none */
  std::string folder; /**< for an output of each input; empty: none */

  /** \brief Whether each input gets an output of its own. */
  bool
  isBatch() const
  {
    return !folder.empty();
  }
};

/** \brief How a program calls its names, and what it makes of several. */
struct FileRules {
  const char* input;  /**< the argument, in capitals */
  const char* output; /**< the same */
  const char* remedy; /**< what several inputs need */
  bool merges;        /**< whether several inputs make one output */
};

/** \brief Add --output and --output-folder, the arguments \a input and \a output, and
 * any number of further ones. */
void
addFileNames(CommandLine& command_line,
             const std::string& input,
             const std::string& output);

/** \brief Take the names for which addFileNames() has made room. Where --output or
 * --output-folder is given, all names without a dash are inputs; else there may be one
 * and the output. Of more names none may be the output, nor with \a merges of two: it
 * could be the last of a list of scans. */
Status
takeFileNames(const Arguments& arguments, const FileRules& rules, FileNames& names);

} // namespace app
