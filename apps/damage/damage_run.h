// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: decides which points pcl_damage_cloud takes out, and parts
// them.
#pragma once

#include <pcl/surface_ccaa/global_shift.h>
#include <pcl/PolygonMesh.h>

#include "damage_regions.h"
#include "io/file_format.h"

namespace app {

/** \brief What the user asked pcl_damage_cloud for. */
struct DamageSettings {
  std::string input;
  std::string output;
  std::string removed;
  std::string free_points;
  std::string report;
  FileFormat format = FileFormat::UNKNOWN; /**< on standard output, if it was given */
  std::vector<std::string> spheres;
  std::vector<std::string> slabs;
  bool absolute = false;
  pcl::GlobalShift shift; // of the input; the regions are given without it
  unsigned int random_spheres = 0;
  unsigned int random_slabs = 0;
  unsigned int random_patches = 0;
  double sphere_size = 0.05; // share of the diagonal
  double slab_size = 0.05;   // share of the extent along the normal
  double patch_size = 0.02;  // share of the points
  double keep = 0;           // share of the removed points
  double noise = 0;          // in mean spacings
  unsigned int seed = 1;
  bool quiet = false;
};

/** \brief What becomes of each point. */
struct Damage {
  Points points;             // as they were, less the shift
  std::vector<char> removed; // in a region
  std::vector<char> kept;    // in a region, but left as a free point
  double deviation = 0;      // of the noise on the kept points, in units of the cloud
};

/** \brief Decide what becomes of each point. Fails for regions that cannot be
 * understood or that hold every point. */
void
planDamage(const DamageSettings& settings,
           const pcl::PolygonMesh& mesh,
           RandomNumbers& random,
           Damage& damage);

/** \brief A file to be written, all of which appear together at the end. */
struct DamagePart {
  std::string path;
  pcl::PolygonMesh mesh;
};

/** \brief The files asked for; noise is put on the kept points of \a mesh on the way.
 */
std::vector<DamagePart>
makeParts(const DamageSettings& settings,
          const Damage& damage,
          RandomNumbers& random,
          pcl::PolygonMesh& mesh);

} // namespace app
