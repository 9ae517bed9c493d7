// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the base algorithm within a hole of which only the rim is
// known.

#pragma once

#include "filling/filling_method.h"

#include <vector>

namespace pcl::repair {

/** \brief What the base algorithm builds inside a hole.
 * \param[in] samples which of the task's free points to use
 * \return triangles, wound like the surface around; corners below the polygon's size
 * are its points, then follow the samples. Not necessarily connected, nor complete. */
Triangles
completeWithin(const FillingTask& task, const std::vector<std::size_t>& samples);

} // namespace pcl::repair
