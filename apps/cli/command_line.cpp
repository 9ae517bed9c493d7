// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: options of a program, each bound to what it sets.
#include "command_line.h"

#include <sstream>

namespace app {
namespace {

namespace po = boost::program_options;

template <typename Number>
void
checkRange(const std::string& name, Number value, std::pair<Number, Number> range)
{
  if (value >= range.first && value <= range.second)
    return;
  std::ostringstream text;
  text << "--" << name << " must be from " << range.first << " to " << range.second
       << ", not " << value;
  throw Failure(text.str());
}

} // namespace

void
OptionGroup::Waiting::operator()(const std::string& help, const std::string& use)
{
  const std::string text = use.empty() ? help : help + "; use it " + use;
  auto add = group.options_.add_options();
  if (type == nullptr)
    add(name.c_str(), text.c_str());
  else
    add(name.c_str(), type, text.c_str());
  group.takes_.emplace_back(name.substr(0, name.find(',')), std::move(take));
}

OptionGroup::Waiting
OptionGroup::flag(const std::string& name, std::function<void()> act)
{
  const auto take = [act = std::move(act)](const Variable&) { act(); };
  return {*this, name, nullptr, take};
}

OptionGroup::Waiting
OptionGroup::parsed(const std::string& name,
                    std::function<void(const std::string&)> take,
                    const std::string& default_text)
{
  auto* type = po::value<std::string>();
  if (!default_text.empty())
    type->default_value(default_text);
  return {*this, name, type, [take = std::move(take)](const Variable& variable) {
            if (!variable.defaulted())
              take(variable.as<std::string>());
          }};
}

OptionGroup::Waiting
OptionGroup::text(const std::string& name, std::string& value)
{
  const auto take = [&value](const std::string& given) { value = given; };
  return parsed(name, take, value);
}

OptionGroup::Waiting
OptionGroup::name(const std::string& option, std::string& value)
{
  const std::string long_name = option.substr(0, option.find(','));
  return parsed(option, [&value, long_name](const std::string& given) {
    value = given;
    if (given.empty())
      throw Failure("--" + long_name + " needs a name");
  });
}

OptionGroup::Waiting
OptionGroup::texts(const std::string& name, std::vector<std::string>& values)
{
  using Texts = std::vector<std::string>;
  const auto take = [&values](const Variable& variable) {
    const Texts given = variable.as<Texts>();
    values.insert(values.end(), given.begin(), given.end());
  };
  return {*this, name, po::value<Texts>()->composing(), take};
}

OptionGroup::Waiting
OptionGroup::wholeNumber(const std::string& name,
                         long long value,
                         std::pair<long long, long long> range,
                         const std::function<void(long long)>& set,
                         bool is_optional)
{
  const auto take = [name, range, set](const Variable& variable) {
    const auto number = variable.as<long long>();
    checkRange(name, number, range);
    if (!variable.defaulted())
      set(number);
  };
  auto* const type = po::value<long long>();
  return {*this,
          name,
          is_optional ? type->implicit_value(value) : type->default_value(value),
          take};
}

OptionGroup::Waiting
OptionGroup::real(const std::string& name, double& value, double lowest, double highest)
{
  std::ostringstream few_digits;
  few_digits << value;
  const auto take = [&value, name, lowest, highest](const Variable& variable) {
    value = variable.as<double>();
    checkRange(name, value, {lowest, highest});
  };
  auto* const type = po::value<double>()->default_value(value, few_digits.str());
  return {*this, name, type, take};
}

CommandLine::CommandLine(Usage usage, bool& quiet) : usage_(std::move(usage))
{
  options_.options_.add_options()("help,h", "print this text and stop")(
      "version", "print the version and stop");
  options_.flag("quiet,q", quiet)(
      "print nothing but errors: no progress, no summary, no notes", "in scripts");
  options_.options_.add_options()(
      "force",
      "write over files that hold points without triangles and were not written by "
      "these programs, such as scans; refused otherwise; use it where they may go");
}

void
CommandLine::positional(const std::string& name, std::string& value)
{
  hidden_.text(name, value)("", "");
  positional_.add(name.c_str(), 1);
  required_.push_back(name);
}

void
CommandLine::positional(const std::string& name,
                        std::vector<std::string>& values,
                        bool is_required)
{
  hidden_.parsed(
      name, [&values](const std::string& value) { values.push_back(value); })("", "");
  positional_.add(name.c_str(), 1);
  if (is_required)
    required_.push_back(name);
}

void
CommandLine::morePositionals(const std::string& name, std::vector<std::string>& values)
{
  hidden_.texts(name, values)("", "");
  positional_.add(name.c_str(), -1);
}

void
CommandLine::takeAll(const OptionGroup& group) const
{
  for (const auto& [name, take] : group.takes_)
    if (arguments_.count(name) != 0)
      take(arguments_[name]);
}

void
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
    throw Failure(std::string(error.what()) + " (try --help)");
  }
  if (given("help") || given("version"))
    return;
  for (const std::string& name : required_)
    if (!given(name))
      throw Failure(name + " is missing (try --help)");
  for (const OptionGroup* group : {&hidden_, &options_, &method_})
    takeAll(*group);
  for (const auto& check : checks_)
    check();
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
  text << "Examples:\n"
       << usage_.examples
       << "\nExit codes: 0 done; 1 bad usage or bad input, nothing written; 2 done, "
          "but something\nwas left undone (stderr says what); 130 stopped by Ctrl-C.\n";
  return text.str();
}

void
addThreads(CommandLine& command_line, unsigned int& threads)
{
  command_line.options().count("threads", threads, 0, 1024)(
      "number of threads, 0 = all; the result is the same for any",
      "to leave processors to others");
}

} // namespace app
