// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: options of a program, each bound to what it sets.
#include "command_line.h"

#include <sstream>

namespace app {
namespace {

namespace po = boost::program_options;

template <typename Number>
Status
checkRange(const std::string& name, Number value, std::pair<Number, Number> range)
{
  if (value >= range.first && value <= range.second)
    return {};
  std::ostringstream text;
  text << "--" << name << " must be from " << range.first << " to " << range.second
       << ", not " << value;
  return Status::error(text.str());
}

} // namespace

void
OptionGroup::add(const std::string& name,
                 const po::value_semantic* type,
                 const std::string& help,
                 Take take)
{
  options_.add_options()(name.c_str(), type, help.c_str());
  takes_.emplace_back(name.substr(0, name.find(',')), std::move(take));
}

void
OptionGroup::flag(const std::string& name,
                  const std::string& help,
                  std::function<void()> act)
{
  options_.add_options()(name.c_str(), help.c_str());
  takes_.emplace_back(name.substr(0, name.find(',')),
                      [act = std::move(act)](const Variable&) {
                        act();
                        return Status();
                      });
}

void
OptionGroup::parsed(const std::string& name,
                    const std::string& help,
                    std::function<Status(const std::string&)> take,
                    const std::string& default_text)
{
  auto* type = po::value<std::string>();
  if (!default_text.empty())
    type->default_value(default_text);
  add(name, type, help, [take = std::move(take)](const Variable& variable) {
    return variable.defaulted() ? Status() : take(variable.as<std::string>());
  });
}

void
OptionGroup::text(const std::string& name, std::string& value, const std::string& help)
{
  const auto take = [&value](const std::string& given) {
    value = given;
    return Status();
  };
  parsed(name, help, take, value);
}

void
OptionGroup::name(const std::string& option,
                  std::string& value,
                  const std::string& help)
{
  const std::string long_name = option.substr(0, option.find(','));
  parsed(option, help, [&value, long_name](const std::string& given) {
    value = given;
    return given.empty() ? Status::error("--" + long_name + " needs a name") : Status();
  });
}

void
OptionGroup::texts(const std::string& name,
                   std::vector<std::string>& values,
                   const std::string& help)
{
  using Texts = std::vector<std::string>;
  add(name, po::value<Texts>()->composing(), help, [&values](const Variable& variable) {
    const Texts given = variable.as<Texts>();
    values.insert(values.end(), given.begin(), given.end());
    return Status();
  });
}

void
OptionGroup::addCount(const std::string& name,
                      long long value,
                      std::pair<long long, long long> range,
                      const std::function<void(long long)>& set,
                      const std::string& help)
{
  const auto take = [name, range, set](const Variable& variable) {
    const auto number = variable.as<long long>();
    const Status status = checkRange(name, number, range);
    if (status.ok() && !variable.defaulted())
      set(number);
    return status;
  };
  add(name, po::value<long long>()->default_value(value), help, take);
}

void
OptionGroup::real(const std::string& name,
                  double& value,
                  double lowest,
                  double highest,
                  const std::string& help)
{
  std::ostringstream few_digits;
  few_digits << value;
  const auto take = [&value, name, lowest, highest](const Variable& variable) {
    value = variable.as<double>();
    return checkRange(name, value, {lowest, highest});
  };
  add(name, po::value<double>()->default_value(value, few_digits.str()), help, take);
}

CommandLine::CommandLine(Usage usage, bool& quiet) : usage_(std::move(usage))
{
  options_.options_.add_options()("help,h", "print this text and stop")(
      "version", "print the version and stop");
  options_.flag(
      "quiet,q", quiet, "print nothing but errors: no progress, no summary, no notes");
  options_.options_.add_options()(
      "force",
      "write over files that hold points without triangles and were not written by "
      "these programs, such as scans; refused otherwise");
}

void
CommandLine::positional(const std::string& name, std::string& value)
{
  hidden_.text(name, value, "");
  positional_.add(name.c_str(), 1);
  required_.push_back(name);
}

void
CommandLine::positional(const std::string& name,
                        std::vector<std::string>& values,
                        bool is_required)
{
  hidden_.parsed(name, "", [&values](const std::string& value) {
    values.push_back(value);
    return Status();
  });
  positional_.add(name.c_str(), 1);
  if (is_required)
    required_.push_back(name);
}

void
CommandLine::morePositionals(const std::string& name, std::vector<std::string>& values)
{
  hidden_.texts(name, values, "");
  positional_.add(name.c_str(), -1);
}

Status
CommandLine::takeAll(const OptionGroup& group) const
{
  Status status;
  for (const auto& [name, take] : group.takes_)
    if (status.ok() && arguments_.count(name) != 0)
      status = take(arguments_[name]);
  return status;
}

Status
CommandLine::parse(int argc, const char* const* argv)
{
  try {
    po::options_description all;
    all.add(options_.options_).add(method_.options_).add(hidden_.options_);
    const int style =
        po::command_line_style::unix_style & ~po::command_line_style::allow_guessing;
    po::command_line_parser parser(argc, argv);
    po::store(parser.options(all).positional(positional_).style(style).run(),
              arguments_);
  }
  catch (const po::error& error) {
    return Status::error(std::string(error.what()) + " (try --help)");
  }
  if (given("help") || given("version"))
    return {};
  for (const std::string& name : required_)
    if (!given(name))
      return Status::error(name + " is missing (try --help)");
  Status status;
  for (const OptionGroup* group : {&hidden_, &options_, &method_})
    if (status.ok())
      status = takeAll(*group);
  for (const auto& check : checks_)
    if (status.ok())
      status = check();
  return status;
}

std::string
CommandLine::help() const
{
  std::ostringstream text;
  text << "Usage: " << usage_.program << " " << usage_.synopsis << "\n\n"
       << usage_.summary << "\n\n"
       << options_.options_ << "\n";
  if (!method_.options_.options().empty())
    text << method_.options_ << "\n";
  text
      << "Examples:\n"
      << usage_.examples
      << "\nExit codes: 0 done; 1 bad usage or bad input, nothing written; 2 done, but "
         "something\nwas left undone (stderr says what); 130 stopped by Ctrl-C.\n";
  return text.str();
}

void
addThreads(CommandLine& command_line, unsigned int& threads)
{
  command_line.options().count(
      "threads",
      threads,
      0,
      1024,
      "number of threads, 0 = all; the result is the same for any");
}

} // namespace app
