// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what every method that is compared gives back.
#pragma once

#include <pcl/PolygonMesh.h>

#include "input_clouds.h"
#include "mesh/triangle.h"

#include <functional>
#include <string>
#include <vector>

namespace bench {

/** \brief A result, whoever made it. Bringing it into this form is not in the time. */
struct Reconstruction {
  pcl::ccaa::Triangles triangles; /**< in indices of the cloud */
  double seconds = 0;             /**< search and normals included */
};

/** \brief A method and its settings for one cloud. */
struct Method {
  std::string name;
  std::function<Reconstruction()> run;
};

/** \brief Ours: consecutive reconstruction, all defaults.
 * \param[in] threads 0 = all */
Reconstruction
reconstruct(const Cloud::Ptr& cloud, unsigned int threads);

/** \brief Peak memory of reconstruct() with all threads, above the cloud and the
 * result, in bytes per point. */
double
peakBytesPerPoint(const Cloud::Ptr& cloud);

} // namespace bench
