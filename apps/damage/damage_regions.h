// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: spheres and slabs inside which points are taken away.
#pragma once

#include <pcl/surface_ccaa/global_shift.h>

#include <Eigen/Geometry>

#include "io/status.h"
#include "random_numbers.h"

#include <string>
#include <vector>

namespace app {

using Points = std::vector<Eigen::Vector3f>;

/** \brief All points closer to \a center than \a radius, in units of the cloud. */
struct Sphere {
  Eigen::Vector3d center;
  double radius = 0;
};

/** \brief All points p with |normal . p - middle| at most half_thickness, in units of
 * the cloud; \a normal has length 1. */
struct Slab {
  Eigen::Vector3d normal;
  double middle = 0;
  double half_thickness = 0;
};

/** \brief Turns what the user writes into regions of one cloud.
 *
 * Places along an axis are shares of the bounding box from 0 to 1, radii are shares of
 * its diagonal; offset and thickness of a slab are shares of the extent of the cloud
 * along the normal. With \a absolute all of them are in units of the cloud, in its
 * frame; points and regions are less the shift. */
class RegionMaker {
public:
  RegionMaker(const Points& points, bool absolute, const pcl::GlobalShift& shift = {});

  /** \brief From "x,y,z,r". */
  void
  parseSphere(const std::string& text, Sphere& sphere) const;

  /** \brief From "nx,ny,nz,offset,thickness". */
  void
  parseSlab(const std::string& text, Slab& slab) const;

  /** \brief A sphere of \a size diagonals around a random point. */
  Sphere
  randomSphere(double size, RandomNumbers& random) const;

  /** \brief A slab of \a size extents in any direction through the middle 80 %. */
  Slab
  randomSlab(double size, RandomNumbers& random) const;

private:
  Slab
  slabInShares(const Eigen::Vector3d& normal, double offset, double thickness) const;

  const Points& points_;
  bool absolute_;
  Eigen::Vector3d shift_;
  Eigen::AlignedBox3d box_;
  std::vector<std::size_t> finite_;
};

/** \brief Set \a removed for each finite point in the region. */
void
markSphere(const Sphere& sphere, const Points& points, std::vector<char>& removed);
void
markSlab(const Slab& slab, const Points& points, std::vector<char>& removed);

} // namespace app
