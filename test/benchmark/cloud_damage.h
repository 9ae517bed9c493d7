// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: noise, gaps in density and outliers for benchmark clouds.
#pragma once

#include "input_clouds.h"

namespace bench {

/** \brief Root mean square distance of a point to its six nearest neighbors, averaged
 * over all points; 0 for fewer than two points. */
double
meanSpacing(const Cloud& cloud);

/** \brief Move each point along each axis by gaussian noise.
 * \param[in] sigma standard deviation in mean spacings of the cloud */
void
addNoise(Cloud& cloud, double sigma);

/** \brief A random share of the points, in their order.
 * \param[in] share probability of each point, 0 to 1 */
Cloud
thinOut(const Cloud& cloud, double share);

/** \brief Append points at random places of the bounding box grown by 5 % of its
 * diagonal on each side.
 * \param[in] share their number in units of the number of points */
void
addOutliers(Cloud& cloud, double share);

/** \brief The points with a density that falls steadily along the longest axis of the
 * bounding box.
 * \param[in] factor the density at the low end over that at the high end, 1 or more */
Cloud
gradeDensity(const Cloud& cloud, double factor);

} // namespace bench
