// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: words, lines and numbers of a text file, without copies.
#include "text_scanner.h"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <type_traits>

namespace app {

bool
TextScanner::nextLine(std::string_view& line)
{
  if (at_ == end_)
    return false;
  const char* const first = at_;
  while (at_ != end_ && *at_ != '\n' && *at_ != '\r')
    ++at_;
  line = std::string_view(first, static_cast<std::size_t>(at_ - first));
  if (at_ != end_ && *at_++ == '\r' && at_ != end_ && *at_ == '\n')
    ++at_;
  return true;
}

namespace {

/** Words that std::from_chars refuses: "1.#QNAN" and numbers beyond the type's range.
 */
template <typename T>
bool
parseUnusual(std::string_view word, std::errc problem, T& value)
{
  if (problem == std::errc::result_out_of_range) {
    const std::string copy(word);
    value = static_cast<T>(std::strtod(copy.c_str(), nullptr));
    return true;
  }
  const std::size_t hash = word.find("1.#");
  if (hash == std::string_view::npos || hash > 1)
    return false;
  const bool infinite = word.substr(hash + 3, 3) == "INF";
  value = infinite ? std::numeric_limits<T>::infinity()
                   : std::numeric_limits<T>::quiet_NaN();
  if (word.front() == '-')
    value = -value;
  return true;
}

template <typename T>
bool
parseFloating(std::string_view word, T& value)
{
  const auto [end, problem] =
      std::from_chars(word.data(), word.data() + word.size(), value);
  if (problem == std::errc() && end == word.data() + word.size())
    return true;
  return parseUnusual(word, problem, value);
}

template <typename T>
bool
parseInteger(std::string_view word, T& value)
{
  const auto [end, problem] =
      std::from_chars(word.data(), word.data() + word.size(), value);
  if (problem == std::errc() && end == word.data() + word.size())
    return true;
  double real = 0;
  if (problem == std::errc::result_out_of_range || !parseFloating(word, real))
    return false;
  const bool fits = real == std::trunc(real) &&
                    real >= static_cast<double>(std::numeric_limits<T>::min()) &&
                    real < std::ldexp(1.0, std::numeric_limits<T>::digits);
  if (fits)
    value = static_cast<T>(real);
  return fits;
}

/** The power of ten of the last digit that is not 0. */
int
lastPower(std::string_view word)
{
  int power = 0;
  int zeros = 0; // at the end, so far
  bool is_fraction = false;
  for (std::size_t i = 0; i < word.size(); ++i) {
    const char c = word[i];
    int exponent = 0;
    if (c == 'e' || c == 'E') {
      parseInteger(word.substr(word.substr(i + 1, 1) == "+" ? i + 2 : i + 1), exponent);
      return power + zeros + exponent;
    }
    is_fraction = is_fraction || c == '.';
    if (c < '0' || c > '9')
      continue;
    power -= is_fraction ? 1 : 0;
    zeros = c == '0' ? zeros + 1 : 0;
  }
  return power + zeros;
}

} // namespace

bool
needsDouble(std::string_view word, double value)
{
  const auto single = static_cast<float>(value);
  const double off = std::abs(double{single} - value);
  if (!(off > 0.0) || !std::isfinite(single))
    return false;
  const int power = lastPower(word);
  const double units = off / std::pow(10.0, power);
  constexpr double little = 1e-6;
  if (std::abs(units - 0.5) > little)
    return units > 0.5;
  const double halves = std::ldexp(double{single}, 1 - power);
  return halves == std::trunc(halves); // else the quotient was rounded
}

template <typename T>
bool
parseNumber(std::string_view word, T& value)
{
  if (!word.empty() && word.front() == '+')
    word.remove_prefix(1);
  if (word.empty())
    return false;
  if constexpr (std::is_floating_point_v<T>)
    return parseFloating(word, value);
  else
    return parseInteger(word, value);
}

#define PSR_PARSE(type) template bool parseNumber(std::string_view, type&);
PSR_PARSE(float)
PSR_PARSE(double)
PSR_PARSE(std::int8_t)
PSR_PARSE(std::uint8_t)
PSR_PARSE(std::int16_t)
PSR_PARSE(std::uint16_t)
PSR_PARSE(std::int32_t)
PSR_PARSE(std::uint32_t)
PSR_PARSE(std::int64_t)
PSR_PARSE(std::uint64_t)
#undef PSR_PARSE

} // namespace app
