// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what PCL's reconstruct() does not look at before it works.
#pragma once

#include <pcl/surface/reconstruction.h>
#include <pcl/PolygonMesh.h>

#include <vector>

namespace pcl::ccaa {

/** \brief A MeshConstruction that survives what PCL's reconstruct() crashes on: no
 * input cloud, and a search method that cannot search it. Both are errors (PCL_ERROR)
 * with empty output. The derived class decides itself which points its search method
 * is to hold. */
template <typename PointT>
class CheckedConstruction : public MeshConstruction<PointT> {
public:
  using MeshConstruction<PointT>::input_;
  using MeshConstruction<PointT>::tree_;

  CheckedConstruction();
  ~CheckedConstruction() override;

  void
  reconstruct(pcl::PolygonMesh& output) override;

  void
  reconstruct(std::vector<pcl::Vertices>& polygons) override;

protected:
  /** \brief Whether reconstruct() can begin; if not, why has been told. */
  bool
  hasUsableCloud(const char* method) const;
};

} // namespace pcl::ccaa

#ifdef PCL_NO_PRECOMPILE
#include <pcl/surface_ccaa/impl/checked_construction.hpp>
#endif
