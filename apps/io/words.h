// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: values that users write as words.
#pragma once

#include <cstddef>
#include <string>

namespace app {

/** \brief A value and its word in files and on the command line. */
template <typename Value>
struct Word {
  const char* word;
  Value value;
};

/** \brief The word of a value; empty if it has none. */
template <typename Value, std::size_t Size>
const char*
wordFor(const Word<Value> (&words)[Size], Value value)
{
  for (const Word<Value>& word : words)
    if (word.value == value)
      return word.word;
  return "";
}

/** \brief All words, such as "all, holes or none". */
template <typename Value, std::size_t Size>
std::string
listOf(const Word<Value> (&words)[Size])
{
  std::string list = words[0].word;
  for (std::size_t i = 1; i < Size; ++i)
    list += (i + 1 < Size ? ", " : " or ") + std::string(words[i].word);
  return list;
}

} // namespace app
