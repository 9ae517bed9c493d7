// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which names on the command line are inputs, and which the
// output.
#include "file_names.h"

namespace app {
namespace {

constexpr const char* further_names = "MORE";

void
sortNames(const FileRules& rules, FileNames& names)
{
  if (names.isBatch() && !names.output.empty())
    throw Failure("--output names one file, --output-folder a folder for one of each "
                  "input; they do not go together");
  const bool merges = rules.merges != nullptr && *rules.merges;
  const std::size_t count = names.inputs.size();
  const bool has_place =
      !names.output.empty() || (rules.instead != nullptr && !rules.instead->empty());
  if (names.isBatch() || count == 1 || (merges && has_place))
    return;
  if (merges || count > 2 || !names.output.empty())
    throw Failure(std::string("several inputs need ") + rules.remedy + " (try --help)");
  names.output = names.inputs.back();
  names.inputs.pop_back();
}

} // namespace

Target
FileNames::target() const
{
  return isBatch() && output.empty() ? Target("", format) : makeTarget(output, format);
}

void
addFileNames(CommandLine& command_line, const FileRules& rules, FileNames& names)
{
  const std::string to_file = "write the mesh to this file (" +
                              std::string(mesh_output_endings) +
                              "); all names without a dash are inputs then";
  OptionGroup& options = command_line.options();
  options.name("output,o", names.output)(to_file,
                                         "with more names than two, or in scripts");
  options.name("output-folder", names.folder)(
      "write NAME.ply to this folder (made if missing) for each of any number of "
      "inputs; --format chooses another ending",
      "for many models at once");
  command_line.positional(rules.input, names.inputs);
  command_line.positional(rules.output, names.inputs, false);
  command_line.morePositionals(further_names, names.inputs);
  command_line.then([rules, &names] { return sortNames(rules, names); });
}

void
addFormatOption(CommandLine& command_line,
                const std::string& list,
                FileFormat& format,
                std::function<bool()> is_needed)
{
  command_line.options().parsed(
      "format",
      [&format](const std::string& name) {
        format = formatOfName(name);
        if (format == FileFormat::UNKNOWN)
          throw Failure("--format '" + name + "' is not known (try --help)");
      })("format of an output whose name does not tell it: " + list,
         "for standard output and many outputs");
  command_line.then([&format, is_needed = std::move(is_needed)] {
    if (format != FileFormat::UNKNOWN && !is_needed())
      throw Failure("--format is for outputs without an ending of their own; the "
                    "ending of the output's name tells its format");
  });
}

void
addFormatOption(CommandLine& command_line, FileNames& names, const std::string& what)
{
  addFormatOption(command_line, "ply, vtk, obj, off or stl", names.format, [&names] {
    return names.isBatch() || isStandardStream(names.output);
  });
  command_line.then([&names, what] {
    if (names.isBatch() && names.format == FileFormat::UNKNOWN)
      names.format = FileFormat::PLY;
    if (names.isBatch() && !isMeshOutput(names.target()))
      throw Failure("--format" + what + " must be one of ply, vtk, obj, off and stl");
  });
}

Target
makeTarget(const std::string& path, FileFormat format)
{
  return isStandardStream(path) && format != FileFormat::UNKNOWN ? Target(path, format)
                                                                 : Target(path);
}

std::string
summaryName(const std::string& path, const char* stream)
{
  return isStandardStream(path) ? stream : path;
}

} // namespace app
