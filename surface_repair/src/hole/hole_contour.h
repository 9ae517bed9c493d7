// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the contour of a hole between boundaries and bridges
// (4.47).

#pragma once

#include "bridge/bridge.h"

#include <cstddef>
#include <vector>

namespace pcl::repair {

/** \brief A piece of a boundary, walked in positive direction. Where `to` does not lie
 * after `from` it goes on over the first point of the curve; where both are the same it
 * is the whole boundary. */
struct BoundarySection {
  BoundaryPoint from;
  BoundaryPoint to; /**< on the same curve */
};

/** \brief Pass a bridge, then walk the boundary to the next supporting point. */
struct ContourStep {
  std::size_t bridge = NONE; /**< NONE: the whole boundary is the contour */
  bool backward = false;     /**< from its end to its beginning */
  BoundarySection section;
};

/** \brief The closed contour of a hole, the surface on the left of its sections. */
struct HoleContour {
  std::vector<ContourStep> steps; /**< at least one */
};

/** \brief Contours of all holes, and the bridges that had to go. */
struct ContourExtraction {
  std::vector<HoleContour> contours;
  std::vector<std::size_t> removed_bridges; /**< ascending; see extractContours() */
};

/** \brief Extract the contours of all holes from boundaries and bridges (4.47).
 *
 * From a supporting point over its bridge, from there along the boundary in positive
 * direction to the next supporting point, and so on until the contour closes. When a
 * contour has passed a bridge twice (C4.47-3, lemma L4.47-1), all bridges that it
 * passed twice are deleted and the extraction begins anew; so it ends after as many
 * rounds as there are bridges at the most. A bridge with a supporting point that an
 * earlier bridge has (C4.47-2) is deleted at once.
 *
 * Afterwards every section of every boundary belongs to exactly one contour (C4.47-1),
 * and every bridge that is left is passed by two contours, once each. A boundary
 * without a bridge is a contour by itself. Contours begin at the lowest curve and arc
 * that no earlier one has. Cost: n log n for n bridges, for each round. */
ContourExtraction
extractContours(const BoundaryEdges& boundaries, const std::vector<Bridge>& bridges);

/** \brief A contour as a closed curve: the points of its sections and bridges, with the
 * normals of the boundary and of the bridges. */
BoundaryCurve
curveOf(const HoleContour& contour,
        const BoundaryEdges& boundaries,
        const std::vector<Bridge>& bridges);

} // namespace pcl::repair
