// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: options of a program, each bound to what it sets.
#pragma once

#include <boost/program_options.hpp>

#include "io/status.h"
#include "io/words.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace app {

/** \brief What the usage text says besides the options. */
struct Usage {
  std::string program;
  std::string synopsis; /**< what follows the program's name on the first line */
  std::string summary;  /**< what the program does, in a few lines */
  std::string examples; /**< lines a newcomer can copy */
};

/** \brief Options under one heading of the help. Each is bound to a variable, which has
 * to outlive the command line; the value that it has when it is bound is the default.
 */
class OptionGroup {
public:
  explicit OptionGroup(const std::string& heading) : options_(heading, 88, 50) {}

  /** \brief What makes \a value what it is \a when_given. */
  void
  flag(const std::string& name,
       bool& value,
       const std::string& help,
       bool when_given = true)
  {
    flag(name, help, [&value, when_given] { value = when_given; });
  }
  void
  flag(const std::string& name, const std::string& help, std::function<void()> act);

  /** \brief A text; one that is not empty is told as the default. */
  void
  text(const std::string& name, std::string& value, const std::string& help);

  /** \brief A text that must not be empty. */
  void
  name(const std::string& option, std::string& value, const std::string& help);

  /** \brief A text that may come several times. */
  void
  texts(const std::string& name,
        std::vector<std::string>& values,
        const std::string& help);

  /** \brief A text that \a take understands, or says why not. It is not called with the
   * default. */
  void
  parsed(const std::string& name,
         const std::string& help,
         std::function<Status(const std::string&)> take,
         const std::string& default_text = "");

  /** \brief A whole number from \a lowest to \a highest. */
  template <typename Count>
  void
  count(const std::string& name,
        Count& value,
        long long lowest,
        long long highest,
        const std::string& help)
  {
    addCount(
        name,
        static_cast<long long>(value),
        {lowest, highest},
        [&value](long long number) { value = static_cast<Count>(number); },
        help);
  }

  /** \brief A real number from \a lowest to \a highest. */
  void
  real(const std::string& name,
       double& value,
       double lowest,
       double highest,
       const std::string& help);

  /** \brief One of some words. */
  template <typename Value, std::size_t Size>
  void
  choice(const std::string& name,
         Value& value,
         const Word<Value> (&words)[Size],
         const std::string& help)
  {
    const auto take = [&value, &words, name](const std::string& text) {
      for (const Word<Value>& word : words)
        if (text == word.word) {
          value = word.value;
          return Status();
        }
      return Status::error("--" + name + " must be " + listOf(words) + ", not '" +
                           text + "'");
    };
    parsed(name, help, take, wordFor(words, value));
  }

private:
  friend class CommandLine;
  using Variable = boost::program_options::variable_value;
  using Take = std::function<Status(const Variable&)>;

  void
  addCount(const std::string& name,
           long long value,
           std::pair<long long, long long> range,
           const std::function<void(long long)>& set,
           const std::string& help);
  void
  add(const std::string& name,
      const boost::program_options::value_semantic* type,
      const std::string& help,
      Take take);

  boost::program_options::options_description options_;
  std::vector<std::pair<std::string, Take>> takes_; /**< by name, in order */
};

/** \brief All options of one app; --help, --version, --quiet and --force are there from
 * the start. */
class CommandLine {
public:
  /** \param[out] quiet whether --quiet was given */
  CommandLine(Usage usage, bool& quiet);
  CommandLine(const CommandLine&) = delete;
  CommandLine&
  operator=(const CommandLine&) = delete;

  OptionGroup&
  options()
  {
    return options_;
  }

  /** \brief Parameters of the method, which the help has behind all others. */
  OptionGroup&
  method()
  {
    return method_;
  }

  /** \brief An argument without a dash; \a name in capitals. */
  void
  positional(const std::string& name, std::string& value);

  /** \brief The same, put behind those that are there already. */
  void
  positional(const std::string& name,
             std::vector<std::string>& values,
             bool is_required = true);

  /** \brief Any number of further ones. */
  void
  morePositionals(const std::string& name, std::vector<std::string>& values);

  /** \brief What is looked at when all values have been taken, in order. */
  void
  then(std::function<Status()> check)
  {
    checks_.push_back(std::move(check));
  }

  /** \brief Parse the arguments; abbreviations and unknown options are refused. Nothing
   * is taken when the help or the version is asked for. */
  Status
  parse(int argc, const char* const* argv);

  /** \brief Whether an option was given, be it with its default. */
  bool
  given(const std::string& name) const
  {
    return arguments_.count(name) != 0 && !arguments_[name].defaulted();
  }

  std::string
  help() const;

  const std::string&
  program() const
  {
    return usage_.program;
  }

private:
  Status
  takeAll(const OptionGroup& group) const;

  Usage usage_;
  OptionGroup options_{"Options"};
  OptionGroup method_{"Options of the method, whose defaults fit nearly always"};
  OptionGroup hidden_{""};
  boost::program_options::positional_options_description positional_;
  std::vector<std::string> required_;
  std::vector<std::function<Status()>> checks_;
  boost::program_options::variables_map arguments_;
};

/** \brief Add --threads, of which the result does not depend. */
void
addThreads(CommandLine& command_line, unsigned int& threads);

} // namespace app
