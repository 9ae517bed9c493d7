// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how far field and trust reach, derived from the data
// (4.45).

#pragma once

#include <pcl/surface_repair/repair_parameters.h>

#include "field/falloff.h"
#include "field/field_source.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace pcl::repair {

/** \brief Distances across gaps: from places to the sources of other islands.
 *
 * Built once, log-linear, some 0.3 us a source; a question costs two to four
 * microseconds, with two islands as with ten thousand. Const methods may be called from
 * several threads. */
class GapFinder {
public:
  explicit GapFinder(const SourceSet& sources);
  ~GapFinder();
  GapFinder(GapFinder&&) noexcept;

  /** \brief Distance to the nearest source that is not of the silent island, units of
   * the cloud; infinite when there is none. */
  double
  gapAt(const Position& position, std::size_t silent_island) const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/** \brief The gaps at all sources of a curve, its own island silent. */
std::vector<double>
gapsAlong(const SourceCurve& curve, const GapFinder& gaps);

/** \brief q_1 for a place with a gap to cross (4.45): L_1 is the source spacing, L_2
 * the gap with room, at least 4 spacings. Nothing reaches anywhere across an infinite
 * gap. \param[in] spacing of the sources \param[in] gap see GapFinder::gapAt()
 * \param[in] exponent chi: 2.5, 1.7 for long wide gaps \param[in] room L_2 / gap */
Falloff
sourceFalloff(double spacing,
              double gap,
              double exponent = 2.5,
              double room = DEFAULT_ROOM);

/** \brief G for free points (4.45): R_1 is their spacing, R_2 half the distance between
 * the islands there, but no less than R_1. \param[in] exponent gamma */
Falloff
freePointFalloff(double spacing, double gap, double exponent = 1.0);

/** \brief Mean distance of points to their nearest neighbours; 0 for less than two. */
double
meanSpacing(const Positions& points);

} // namespace pcl::repair
