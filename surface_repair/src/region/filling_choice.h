// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which filling method closes a hole.

#pragma once

#include <pcl/surface_repair/repair_parameters.h>

#include "field/free_point_field.h"
#include "filling/filling_method.h"

#include <cstddef>
#include <memory>

namespace pcl::repair {

/** \brief The method of a choice; of AUTOMATIC the one for holes without free points.
 */
std::unique_ptr<const FillingMethod>
methodFor(FillingChoice choice);

/** \brief Edges up to which a hole is simple (D4.1-3). */
std::size_t
simpleEdges(const FillingParameters& parameters);

struct ChosenFilling {
  Filling filling;    /**< free points are numbered as in the field */
  const char* method; /**< name of the method that made it */
};

/** \brief Close a hole by the method of a choice, and by MINIMUM_WEIGHT where that one
 * cannot. \param[in] task without free points \param[in] free_points all there are, or
 * null */
ChosenFilling
fillHole(FillingTask task, FillingChoice choice, const FreePointField* free_points);

} // namespace pcl::repair
