// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what PCL's reconstruct() does not look at before it works.
#pragma once

#include <pcl/console/print.h>
#include <pcl/search/organized.h>
#include <pcl/surface_ccaa/checked_construction.h>
#include <pcl/point_cloud.h>

#include <string>

namespace pcl::ccaa {

/** \brief Whether \a tree can search \a cloud: a search::OrganizedNeighbor needs rows
 * and columns. Null can. */
template <typename PointT>
bool
canSearch(const search::Search<PointT>* tree, const PointCloud<PointT>& cloud)
{
  return (cloud.width > 1 && cloud.height > 1) ||
         dynamic_cast<const search::OrganizedNeighbor<PointT>*>(tree) == nullptr;
}

template <typename PointT>
CheckedConstruction<PointT>::CheckedConstruction()
{
  this->check_tree_ = false;
}

template <typename PointT>
CheckedConstruction<PointT>::~CheckedConstruction() = default;

template <typename PointT>
void
CheckedConstruction<PointT>::reconstruct(pcl::PolygonMesh& output)
{
  if (hasUsableCloud("reconstruct"))
    return MeshConstruction<PointT>::reconstruct(output);
  output.cloud.width = output.cloud.height = 0;
  output.cloud.data.clear();
  output.polygons.clear();
}

template <typename PointT>
void
CheckedConstruction<PointT>::reconstruct(std::vector<pcl::Vertices>& polygons)
{
  if (hasUsableCloud("reconstruct"))
    return MeshConstruction<PointT>::reconstruct(polygons);
  polygons.clear();
}

template <typename PointT>
bool
CheckedConstruction<PointT>::hasUsableCloud(const char* method) const
{
  const std::string name = this->getClassName();
  if (!input_)
    PCL_ERROR("[pcl::%s::%s] no input cloud\n", name.c_str(), method);
  else if (!canSearch(tree_.get(), *input_))
    PCL_ERROR(
        "[pcl::%s::%s] the search method %s needs an organised cloud, this one is "
        "not (width %u, height %u)\n",
        name.c_str(),
        method,
        tree_->getName().c_str(),
        input_->width,
        input_->height);
  else
    return true;
  return false;
}

} // namespace pcl::ccaa

#define PCL_INSTANTIATE_CheckedConstruction(T)                                         \
  template class PCL_EXPORTS pcl::ccaa::CheckedConstruction<T>;
