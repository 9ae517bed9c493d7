// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what there is to say about a result, whoever made it.
#pragma once

#include "mesh/mesh_facts.h"
#include "mesh_distance.h"
#include "reconstruction.h"

#include <memory>
#include <optional>
#include <string>

namespace bench {

/** \brief The true surface that a cloud was taken from. */
struct ReferenceMesh {
  pcl::ccaa::Triangles triangles;
  pcl::ccaa::Positions positions;
  double diagonal = 0; /**< of the box around its triangles, in units of the cloud */
  pcl::ccaa::MeshFacts facts; /**< self-intersections are not looked for */
};

/** \brief The triangles of a file; null when the name is empty or there are none. */
std::shared_ptr<const ReferenceMesh>
readReference(const std::string& file);

/** \brief Facts about one result. */
struct Judgement {
  /** Share of the reference's diagonal from which a triangle counts as far. */
  static constexpr double FAR_SHARE = 0.012;

  pcl::ccaa::MeshFacts facts;
  std::optional<Deviation> deviation; /**< of the result's triangles */
  std::optional<Deviation> missing;   /**< of the reference's triangles from the
                                                   result: what is missing */
};

/** \brief Look at a result. Takes all threads and some us a triangle.
 * \param[in] reference may be null */
Judgement
judge(const Cloud& cloud,
      const pcl::ccaa::Triangles& triangles,
      const ReferenceMesh* reference);

} // namespace bench
