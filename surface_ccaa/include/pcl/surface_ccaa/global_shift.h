// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: coordinates too large for floats, such as those of maps.
#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/PolygonMesh.h>

#include <Eigen/Core>

#include <cstdint>

namespace pcl {

/** \brief An offset taken off coordinates that floats cannot hold, and put back on.
 *
 * Map coordinates are millions of metres, where a float steps by half a metre. Such a
 * cloud has its fields x, y and z as doubles (FLOAT64). Classes that take a raw cloud
 * or a PolygonMesh (UmbrellaFilter, ForceLineHoleRepair, BoundaryClassifier) take it as
 * it is: they work near the origin, and what they append is at the original place, in
 * doubles. Classes on a pcl::PointCloud of floats need the shift:
 *
 * \code
 * const auto shift = pcl::GlobalShift::of(cloud);
 * pcl::PCLPointCloud2 local;
 * shift.toLocal(cloud, local);
 * auto points = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
 * pcl::fromPCLPointCloud2(local, *points);
 * pcl::ConsecutiveReconstruction<pcl::PointXYZ> reconstruction;
 * reconstruction.setInputCloud(points);
 * pcl::PolygonMesh mesh;
 * reconstruction.reconstruct(mesh);
 * shift.restore(cloud, mesh); // mesh.cloud is the cloud, with all its doubles
 * \endcode
 *
 * Other programs call it the same; with theirs, an offset of the opposite sign may be
 * meant. Several clouds of one scene need one shift: that of the largest, or of all.
 */
class GlobalShift {
public:
  /** \brief No shift. */
  GlobalShift() = default;

  /** \brief \param[in] offset to be subtracted, in units of the cloud */
  explicit GlobalShift(const Eigen::Vector3d& offset) : offset_(offset) {}

  /** \brief The shift that a cloud needs, from its positions alone.
   *
   * None where floats do: where rounding to float moves no point by more than a
   * thousandth of the spacing (that of ccaa::measureExtent()). Else the middle of the
   * cloud rounded to the power of ten below its extent, or to the power of two where
   * the extent is below 1, so that differences keep all their digits. The same for
   * float and double fields: floats that are coarse already get no finer, but nothing
   * more is lost. None also for a cloud that cannot be read.
   *
   * Cost: one look at the points. */
  static GlobalShift
  of(const pcl::PCLPointCloud2& cloud);

  /** \brief What is subtracted; zero where there is no shift. */
  const Eigen::Vector3d&
  offset() const
  {
    return offset_;
  }
  bool
  isNone() const
  {
    return offset_.isZero(0.0);
  }

  /** \brief Copy a cloud with x, y and z as floats, less the offset; sensor positions
   * (vp_x, vp_y, vp_z) likewise. All other fields are kept, packed without the padding
   * between them.
   * \return false, with a PCL_ERROR and an empty result, for a cloud that cannot be
   * read
   */
  bool
  toLocal(const pcl::PCLPointCloud2& cloud, pcl::PCLPointCloud2& local) const;

  /** \brief The way back: x, y and z as doubles, with the offset. */
  bool
  toGlobal(const pcl::PCLPointCloud2& local, pcl::PCLPointCloud2& cloud) const;

  /** \brief Put a mesh that was made of toLocal(cloud) back on the cloud: its points
   * become those of the cloud, bit for bit and with all their fields. Points that were
   * appended to the mesh come after them, with the offset; of their other fields those
   * that the cloud has, too, are kept, the rest is zero.
   * \return false, with a PCL_ERROR and the mesh as it was, for a mesh with fewer
   * points than the cloud and for a cloud that cannot be read */
  bool
  restore(const pcl::PCLPointCloud2& cloud, pcl::PolygonMesh& mesh) const;

private:
  Eigen::Vector3d offset_ = Eigen::Vector3d::Zero();
};

} // namespace pcl
