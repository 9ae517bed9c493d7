// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how noisy the samples are that a patch has grown over.

#pragma once

#include "filling/patch.h"

namespace pcl::repair {

/** \brief How far samples stand out of the surface of their neighbours. */
struct SampleNoise {
  double deviation = 0.0; /**< standard, along the normal, units of the cloud */
  double share = 0.0;     /**< the same of the length of the edges there, one standard
                               error less: what is certain of it */
};

/** \brief The noise of the free points that are vertices of a patch, the median of all.
 *
 * Each is compared with the quadric through the vertices within two rings that are
 * measured, too (judgement 7). These are its neighbours on the surface, where the
 * nearest in space may lie on the other side of an ear. Detail finer than the samples
 * cannot be told from noise and counts with it. Nothing where no sample has neighbours
 * enough. Cost: linear. */
SampleNoise
noiseOfSamples(const Patch& patch);

} // namespace pcl::repair
