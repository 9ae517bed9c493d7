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
 * What describes an option is called with its text for the help and when one needs it,
 * which adds it. */
class OptionGroup {
  using Variable = boost::program_options::variable_value;
  using Take = std::function<void(const Variable&)>;

  /** \brief An option that waits for its text. "use it" goes before \a use, such as
   * "for noisy scans"; an argument without a dash has neither. */
  struct [[nodiscard]] Waiting {
    OptionGroup& group;
    std::string name;
    const boost::program_options::value_semantic* type; /**< null: a flag */
    Take take;

    void
    operator()(const std::string& help, const std::string& use);
  };

public:
  explicit OptionGroup(const std::string& heading) : options_(heading, 88, 50) {}

  Waiting
  flag(const std::string& name, std::function<void()> act);

  /** \brief What makes \a value what it is \a when_given. */
  Waiting
  flag(const std::string& name, bool& value, bool when_given = true)
  {
    return flag(name, [&value, when_given] { value = when_given; });
  }

  /** \brief A text; one that is not empty is told as the default. */
  Waiting
  text(const std::string& name, std::string& value);

  /** \brief A text that must not be empty. */
  Waiting
  name(const std::string& option, std::string& value);

  /** \brief A text that may come several times. */
  Waiting
  texts(const std::string& name, std::vector<std::string>& values);

  /** \brief A text that \a take understands, or else throws a Failure. It is not called
   * with the default. */
  Waiting
  parsed(const std::string& name,
         std::function<void(const std::string&)> take,
         const std::string& default_text = "");

  /** \brief A whole number from \a lowest to \a highest. */
  template <typename Count>
  Waiting
  count(const std::string& name, Count& value, long long lowest, long long highest)
  {
    const auto set = [&value](long long number) { value = static_cast<Count>(number); };
    return wholeNumber(name, static_cast<long long>(value), {lowest, highest}, set);
  }

  /** \brief The same, whose number may be left out (--name or --name=N): \a when_bare
   * then. Without the option the value stays as it is. */
  template <typename Count>
  Waiting
  optionalCount(const std::string& name,
                Count& value,
                long long when_bare,
                long long lowest,
                long long highest)
  {
    const auto set = [&value](long long number) { value = static_cast<Count>(number); };
    return wholeNumber(name, when_bare, {lowest, highest}, set, true);
  }

  /** \brief A real number from \a lowest to \a highest. */
  Waiting
  real(const std::string& name, double& value, double lowest, double highest);

  /** \brief One of some words. */
  template <typename Value, std::size_t Size>
  Waiting
  choice(const std::string& name, Value& value, const Word<Value> (&words)[Size])
  {
    const auto take = [&value, &words, name](const std::string& text) {
      for (const Word<Value>& word : words)
        if (text == word.word) {
          value = word.value;
          return;
        }
      throw Failure("--" + name + " must be " + listOf(words) + ", not '" + text + "'");
    };
    return parsed(name, take, wordFor(words, value));
  }

private:
  friend class CommandLine;

  Waiting
  wholeNumber(const std::string& name,
              long long value,
              std::pair<long long, long long> range,
              const std::function<void(long long)>& set,
              bool is_optional = false);

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
  then(std::function<void()> check)
  {
    checks_.push_back(std::move(check));
  }

  /** \brief Parse the arguments. Abbreviations, unknown options and values of no use
   * are refused by a Failure. Nothing is taken when the help or the version is asked
   * for. */
  void
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
  void
  takeAll(const OptionGroup& group) const;

  Usage usage_;
  OptionGroup options_{"Options"};
  OptionGroup method_{"Options of the method, whose defaults fit nearly always"};
  OptionGroup hidden_{""};
  boost::program_options::positional_options_description positional_;
  std::vector<std::string> required_;
  std::vector<std::function<void()>> checks_;
  boost::program_options::variables_map arguments_;
};

/** \brief Add --threads, of which the result does not depend. */
void
addThreads(CommandLine& command_line, unsigned int& threads);

} // namespace app
