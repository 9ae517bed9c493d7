// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: running the filter of a chain.
#pragma once

#include <pcl/surface/processing.h>

#include "consecutive/chain_run.h"

namespace pcl {
namespace ccaa {

/** \brief Filter the triangles of a chain.
 * \param[in,out] given its cloud goes to `left`, untouched; it is still here after a
 * failure \param[in] filter null: nothing is left out \param[out] left what the filter
 * leaves \return false when it returned anything that it was not given */
bool
applyFilter(ChainMesh& given,
            MeshProcessing* filter,
            const ChainRun& run,
            ChainMesh& left);

/** \brief Whether the filter's last run left a region without any consistent winding,
 * to which no triangle can be added with the right one. Only UmbrellaFilter tells. */
bool
leftOneSided(const MeshProcessing* filter);

} // namespace ccaa
} // namespace pcl
