// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: options that hold several numbers, such as X,Y,Z.
#pragma once

#include <Eigen/Core>

#include "io/status.h"

#include <array>
#include <charconv>
#include <string>

namespace app {

/** \brief Read exactly \a values.size() numbers divided by \a separator. */
template <typename Number, std::size_t count>
bool
parseList(const std::string& text, char separator, std::array<Number, count>& values)
{
  const char* at = text.data();
  const char* const end = at + text.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0 && (at == end || *at++ != separator))
      return false;
    const auto [next, error] = std::from_chars(at, end, values[i]);
    if (error != std::errc())
      return false;
    at = next;
  }
  return at == end;
}

/** \brief Read X,Y,Z; fails with the name of the option in the message. */
inline void
parsePlace(const std::string& option, const std::string& text, Eigen::Vector3d& place)
{
  std::array<double, 3> values{};
  if (!parseList(text, ',', values))
    throw Failure("--" + option + " takes X,Y,Z, not '" + text + "'");
  place = Eigen::Vector3d(values[0], values[1], values[2]);
  if (!place.allFinite())
    throw Failure("--" + option + " must be finite, not '" + text + "'");
}

} // namespace app
