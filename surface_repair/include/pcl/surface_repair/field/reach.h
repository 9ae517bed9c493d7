// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how far the field has to reach, from the data (4.45).

#pragma once

#include <pcl/surface_repair/field/field_source.h>

#include <cstddef>

namespace pcl {
namespace repair {

/** \brief R_1: the mean distance from a point to its nearest neighbour; 0 for fewer
 * than two points (4.45). */
double
meanPointSpacing(const Positions& points);

/** \brief Distances from places to the sources of other islands: the gaps that bridges
 * have to cross. The sources must outlive it. */
class GapFinder {
public:
  explicit GapFinder(const SourceSet& sources) : sources_(sources) {}

  /** \brief Distance to the nearest source that is not of the silent island; infinite
   * when there is none. */
  double
  gapAt(const Position& position, std::size_t silent_island) const;

private:
  const SourceSet& sources_;
};

} // namespace repair
} // namespace pcl
