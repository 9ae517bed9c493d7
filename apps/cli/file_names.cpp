// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which names on the command line are inputs, and which the
// output.
#include "file_names.h"

#include "io/model_io.h"

namespace app {
namespace {

constexpr const char* further_names = "MORE";

/** Given, and then not empty. */
Status
takeName(const Arguments& arguments, const std::string& option, std::string& name)
{
  name = takeText(arguments, option);
  return arguments.count(option) != 0 && name.empty()
             ? Status::error("--" + option + " needs a name")
             : Status();
}

std::vector<std::string>
namesWithoutDash(const Arguments& arguments, const FileRules& rules)
{
  std::vector<std::string> names{takeText(arguments, rules.input)};
  if (arguments.count(rules.output) != 0)
    names.push_back(takeText(arguments, rules.output));
  for (const std::string& name : takeTexts(arguments, further_names))
    names.push_back(name);
  return names;
}

} // namespace

void
addFileNames(CommandLine& command_line,
             const std::string& input,
             const std::string& output)
{
  using boost::program_options::value;
  const std::string to_file = "write the mesh to this file (" +
                              std::string(mesh_output_endings) +
                              "); all names without a dash are inputs then";
  command_line.addOptions()("output,o", value<std::string>(), to_file.c_str())(
      "output-folder",
      value<std::string>(),
      "write NAME.ply to this folder (made if missing) for each of any number of "
      "inputs; --format chooses another ending");
  command_line.addPositional(input);
  command_line.addOptionalPositional(output);
  command_line.addMorePositionals(further_names);
}

Status
takeFileNames(const Arguments& arguments, const FileRules& rules, FileNames& names)
{
  Status status = takeName(arguments, "output", names.output);
  if (status.ok())
    status = takeName(arguments, "output-folder", names.folder);
  if (status.ok() && names.isBatch() && !names.output.empty())
    status = Status::error("--output names one file, --output-folder a folder for one "
                           "of each input; they do not go together");
  if (!status.ok())
    return status;
  names.inputs = namesWithoutDash(arguments, rules);
  const std::size_t count = names.inputs.size();
  if (names.isBatch() || count == 1 || (rules.merges && !names.output.empty()))
    return {};
  if (rules.merges || count > 2 || !names.output.empty())
    return Status::error(std::string("several inputs need ") + rules.remedy +
                         " (try --help)");
  names.output = names.inputs.back();
  names.inputs.pop_back();
  return {};
}

} // namespace app
