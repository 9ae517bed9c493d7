// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the chain of algorithms on arrays of points.
#pragma once

#include <pcl/surface_ccaa/global_shift.h>

#include "cli/reconstruct_run.h"
#include "options.h"

#include <string>

namespace app::python {

/** \brief What reconstruct() is asked for. */
struct ChainTask {
  ReconstructOptions options;
  std::string until = "base"; /**< start, filter or base */
  pcl::ccaa::SideHints sides;
  bool normals = false;
  unsigned int threads = 0;
  pcl::ccaa::ProgressCallback progress;
};

/** \brief Mesh the cloud of \a result. It has x, y and z as floats or doubles; normals
 * and viewpoints count where they are floats. Map coordinates are replaced by those
 * near the origin, of which the result speaks; the shift is in its model. Throws
 * Failure for options out of range; all other errors are told. */
void
runChain(ChainTask& task, ReconstructResult& result);

/** \brief The report of a run, as JSON.
 * \param[in] seconds of all of it */
std::string
reportOf(const ChainTask& task, ReconstructResult& result, double seconds);

} // namespace app::python
