// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: Open3D's ball pivoting as a rival, where it is installed.
#include "measuring.h"
#include "rivals.h"

#ifdef PSR_HAVE_OPEN3D
#include <open3d/geometry/KDTreeSearchParam.h>
#include <open3d/geometry/PointCloud.h>
#include <open3d/geometry/TriangleMesh.h>
#endif

#include <memory>

namespace bench {

#ifdef PSR_HAVE_OPEN3D

namespace {

std::shared_ptr<open3d::geometry::TriangleMesh>
pivot(const Cloud& cloud, double spacing)
{
  open3d::geometry::PointCloud oriented;
  oriented.points_.reserve(cloud.size());
  for (const pcl::PointXYZ& p : cloud)
    oriented.points_.push_back(p.getVector3fMap().cast<double>());
  oriented.EstimateNormals(open3d::geometry::KDTreeSearchParamKNN(12));
  // Balls roll on one side of the surface only, so the normals have to agree.
  oriented.OrientNormalsConsistentTangentPlane(12);
  return open3d::geometry::TriangleMesh::CreateFromPointCloudBallPivoting(
      oriented, {0.75 * spacing, 1.5 * spacing, 3 * spacing});
}

} // namespace

bool
hasBallPivoting()
{
  return true;
}

Reconstruction
ballPivoting(const Cloud& cloud, double spacing)
{
  Reconstruction result;
  std::shared_ptr<open3d::geometry::TriangleMesh> mesh;
  result.seconds = secondsOf([&] { mesh = pivot(cloud, spacing); });
  for (const Eigen::Vector3i& t : mesh->triangles_)
    result.triangles.push_back({t[0], t[1], t[2]});
  return result;
}

#else

bool
hasBallPivoting()
{
  return false;
}

Reconstruction
ballPivoting(const Cloud&, double)
{
  return {};
}

#endif

} // namespace bench
