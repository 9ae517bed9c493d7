// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the option for outputs whose names tell no format.
#pragma once

#include "cli.h"
#include "io/model_io.h"

#include <string>

namespace app {

/** \brief Add --format; \a names lists what may be given. */
void
addFormatOption(CommandLine& command_line, const std::string& names);

/** \brief Take --format; \a format stays UNKNOWN without it. Fails for a format that is
 * not known, and when each output has an ending of its own (\a is_needed false). */
Status
takeFormat(const Arguments& arguments, bool is_needed, FileFormat& format);

/** \brief A named file in the format of its ending, "-" in \a format, or PLY. */
Target
makeTarget(const std::string& path, FileFormat format);

/** \brief Name of an output in the summary of a run. */
std::string
summaryName(const std::string& path);

} // namespace app
