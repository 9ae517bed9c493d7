// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: words, lines and numbers of a text file, without copies.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace app {

/** \brief Walks over text word by word or line by line. Views point into the text. */
class TextScanner {
public:
  explicit TextScanner(std::string_view text)
  : at_(text.data()), end_(text.data() + text.size())
  {}

  /** \brief Next word between white space.
   * \return false at the end of the text. */
  bool
  nextWord(std::string_view& word)
  {
    while (at_ != end_ && isSpace(*at_))
      ++at_;
    const char* const first = at_;
    while (at_ != end_ && !isSpace(*at_))
      ++at_;
    word = std::string_view(first, static_cast<std::size_t>(at_ - first));
    return !word.empty();
  }

  /** \brief Next line without its line end (Unix, Windows or old Mac).
   * \return false at the end of the text. */
  bool
  nextLine(std::string_view& line);

  /** \brief Next word; empty at the end of the text. */
  std::string_view
  word()
  {
    std::string_view next;
    nextWord(next);
    return next;
  }

  const char*
  position() const
  {
    return at_;
  }
  std::size_t
  remaining() const
  {
    return static_cast<std::size_t>(end_ - at_);
  }

  /** \brief Step over \a bytes of binary data, at most to the end. */
  void
  skip(std::size_t bytes)
  {
    at_ += bytes < remaining() ? bytes : remaining();
  }

  static bool
  isSpace(char c)
  {
    return c == ' ' || (c >= '\t' && c <= '\r');
  }

private:
  const char* at_;
  const char* end_;
};

/** \brief Read all of \a word as a number; a leading plus sign, "nan", "inf" and the
 * old Windows spellings of them are understood. Integers may be written as "3.0".
 * Values of too great a magnitude become infinite, too small ones zero. \return false
 * when the word is not such a number or an integer is out of range. */
template <typename T>
bool
parseNumber(std::string_view word, T& value);

/** \brief Read the next word as a number. \return false where there is none. */
template <typename T>
bool
nextNumber(TextScanner& words, T& value)
{
  return parseNumber(words.word(), value);
}

/** \brief Whether a float would lose digits of \a word, whose number is \a value: the
 * nearest float is off by half a unit of the last digit or more. A number that a
 * program has printed of a float is off by less. */
bool
needsDouble(std::string_view word, double value);

} // namespace app
