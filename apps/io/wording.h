// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: counts in sentences.
#pragma once

#include <cstddef>
#include <cstdio>
#include <string>

namespace app {

/** \brief A count with its English word, in the plural but for one: "1 boundary",
 * "2 boundaries". */
inline std::string
plural(std::size_t count, std::string word)
{
  const bool ends_in_y = word.size() > 1 && word.back() == 'y' &&
                         std::string("aeiou").find(word[word.size() - 2]) == word.npos;
  if (count != 1 && ends_in_y)
    word.replace(word.size() - 1, 1, "ies");
  else if (count != 1)
    word += "s";
  return std::to_string(count) + " " + word;
}

/** \brief The same with the verb: "1 hole is", "2 holes are". */
inline std::string
pluralIs(std::size_t count, const std::string& word)
{
  return plural(count, word) + (count == 1 ? " is" : " are");
}

/** \brief The same with "has" or "have". */
inline std::string
pluralHas(std::size_t count, const std::string& word)
{
  return plural(count, word) + (count == 1 ? " has" : " have");
}

/** \brief A short text as printf() has it. */
template <typename... Values>
std::string
formatted(const char* format, Values... values)
{
  char text[256];
  std::snprintf(text, sizeof(text), format, values...);
  return text;
}

/** \brief A list in a sentence: what is added to it stands behind commas. */
inline void
addToList(std::string& list, const std::string& what)
{
  list += (list.empty() ? "" : ", ") + what;
}

} // namespace app
