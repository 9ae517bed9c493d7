// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: table T3.5-1 of the thesis on our data.
#pragma once

#include <pcl/surface_ccaa/reconstruction_report.h>

#include "input_clouds.h"

#include <cstddef>
#include <string>

namespace bench {

/** \brief Our base algorithm alone against the whole chain, on one thread: the medians
 * of a number of runs. */
pcl::SpeedupReport
measureSpeedup(const Cloud::Ptr& cloud, std::size_t repeats);

/** \brief Headings of T3.5-1, extended by the costs of EC3.1-1, and the thesis' own
 * rows. */
void
printSpeedupHeadings();

/** \brief A row of ours. */
void
printSpeedup(const std::string& name, const pcl::SpeedupReport& report);

} // namespace bench
