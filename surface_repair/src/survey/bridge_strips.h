// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: bridges that lead beside each other.

#pragma once

#include "survey/model_survey.h"

#include <array>
#include <cstddef>
#include <map>
#include <vector>

namespace pcl::repair {

/** Bridges of a strip that carries no handle, however straight its junction, unless it
 * leads all around or its junction is that likely. */
constexpr std::size_t ISTHMUS = 2;

/** \brief The curves of two boundaries, ascending. */
using CurvePair = std::array<std::size_t, 2>;

/** \brief Numbers of bridges, ascending. */
using Bridges = std::vector<std::size_t>;

/** \brief Bridges of the same two boundaries with nothing but them between each two
 * neighbours. */
struct Strip {
  Bridges bridges;
  std::size_t contours = 0; /**< between two each: as many where it leads all around */

  bool
  isNarrow() const
  {
    return contours < bridges.size() && bridges.size() <= ISTHMUS;
  }
};

/** \brief Of each pair of boundaries the narrowest strips come first. */
using Strips = std::map<CurvePair, std::vector<Strip>>;

Strips
stripsOf(const SurveyedBridges& joined);

} // namespace pcl::repair
