// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how a fuzz target says that something is wrong.
#pragma once

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

namespace fuzz {

/** \brief Ends the program, which a fuzzer takes for a finding, unless \a holds. */
inline void
require(bool holds, const char* what)
{
  if (holds)
    return;
  std::fprintf(stderr, "does not hold: %s\n", what);
  std::abort();
}

/** \brief The same for a predicate on meshes, with its message. */
inline void
require(const ::testing::AssertionResult& holds, const char* what)
{
  if (!holds)
    std::fprintf(stderr, "%s\n", holds.message());
  require(static_cast<bool>(holds), what);
}

} // namespace fuzz
