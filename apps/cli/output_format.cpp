// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the option for outputs whose names tell no format.
#include "output_format.h"

namespace app {

void
addFormatOption(CommandLine& command_line, const std::string& names)
{
  const std::string help = "format of an output whose name does not tell it: " + names;
  command_line.addOptions()(
      "format", boost::program_options::value<std::string>(), help.c_str());
}

Status
takeFormat(const Arguments& arguments, bool is_needed, FileFormat& format)
{
  if (arguments.count("format") == 0)
    return {};
  const std::string name = takeText(arguments, "format");
  format = formatOfName(name);
  if (format == FileFormat::UNKNOWN)
    return Status::error("--format '" + name + "' is not known (try --help)");
  if (!is_needed)
    return Status::error("--format is for outputs without an ending of their own; the "
                         "ending of the output's name tells its format");
  return {};
}

Target
makeTarget(const std::string& path, FileFormat format)
{
  return isStandardStream(path) && format != FileFormat::UNKNOWN ? Target(path, format)
                                                                 : Target(path);
}

std::string
summaryName(const std::string& path)
{
  return isStandardStream(path) ? "standard output" : path;
}

} // namespace app
