// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how many threads a run gets.
#pragma once

#ifdef _OPENMP
#include <omp.h>
#endif

namespace pcl::ccaa {

/** \brief Number of threads for a request in PCL's manner: 0 means all processors. */
inline int
resolveThreads(unsigned int requested)
{
#ifdef _OPENMP
  return requested == 0 ? omp_get_num_procs() : static_cast<int>(requested);
#else
  (void)requested;
  return 1;
#endif
}

/** \brief Index of the calling worker inside a parallel region; 0 is the thread that
 * started the run, the only one allowed to report progress. */
inline int
threadIndex()
{
#ifdef _OPENMP
  return omp_get_thread_num();
#else
  return 0;
#endif
}

} // namespace pcl::ccaa
