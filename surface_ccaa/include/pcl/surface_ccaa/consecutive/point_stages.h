// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: running the algorithms of a chain that need the cloud.
#pragma once

#include <pcl/surface_ccaa/consecutive/chain_run.h>
#include <pcl/surface_ccaa/consecutive/stage_polygons.h>
#include <pcl/surface_ccaa/mesh_completion.h>
#include <pcl/point_cloud.h>

#include <memory>
#include <vector>

namespace pcl {
namespace ccaa {

/** \brief What every algorithm of a chain is given. */
template <typename PointT>
struct ChainInput {
  typename PointCloud<PointT>::ConstPtr cloud;
  typename MeshConstruction<PointT>::KdTreePtr tree; /**< null: each keeps its own */
};

/** \brief Whether a class of PCL has to get its points as a cloud of their own: it may
 * mix up indices and positions among them (gp3 does), and need not expect points that
 * are not finite. Of organised clouds it does. */
template <typename PointT>
bool
needsCloudOfItsOwn(const PointCloud<PointT>& cloud,
                   const IndicesPtr& chosen,
                   const ChainPoints& points)
{
  const bool knows_gaps = cloud.isOrganized() && !cloud.is_dense;
  return chosen != points.usable || points.is_selection ||
         (points.skipped > 0 && !knows_gaps);
}

/** \brief Run an algorithm that starts from points alone.
 * A cloud of some of the points is no longer organised: an algorithm whose search
 * method needs that loses it.
 * \param[in] chosen cloud indices of points that are finite
 * \param[out] made polygons of cloud indices, not checked */
template <typename PointT>
void
constructFrom(const ChainInput<PointT>& input,
              const IndicesPtr& chosen,
              const ChainPoints& points,
              MeshConstruction<PointT>& algorithm,
              std::vector<Vertices>& made)
{
  if (input.tree)
    algorithm.setSearchMethod(input.tree);
  const bool honours_indices = dynamic_cast<RunSettings*>(&algorithm) != nullptr;
  if (honours_indices || !needsCloudOfItsOwn(*input.cloud, chosen, points)) {
    algorithm.setInputCloud(input.cloud);
    algorithm.setIndices(honours_indices ? chosen : IndicesPtr());
    algorithm.reconstruct(made);
    return;
  }
  const auto part = std::make_shared<PointCloud<PointT>>(*input.cloud, *chosen);
  part->is_dense = true;
  if (!canSearch(algorithm.getSearchMethod().get(), *part))
    algorithm.setSearchMethod(nullptr); // it chooses one that can
  algorithm.setInputCloud(part);
  algorithm.setIndices(IndicesPtr());
  algorithm.reconstruct(made);
  mapToCloud(*chosen, made);
}

/** \brief Run a completion.
 * \param[in] partial_mesh null: there is none
 * \param[out] polygons of cloud indices, the given ones (that it kept) first
 * \return whether it kept to the contract of MeshCompletion */
template <typename PointT>
bool
complete(const ChainInput<PointT>& input,
         const PolygonMeshConstPtr& partial_mesh,
         const ChainRun& run,
         MeshCompletion<PointT>& completion,
         std::vector<Vertices>& polygons)
{
  if (input.tree)
    completion.setSearchMethod(input.tree);
  const AtEnd restore([&completion, own_mesh = completion.getPartialMesh()] {
    completion.setPartialMesh(own_mesh);
  });
  completion.setInputCloud(input.cloud);
  completion.setIndices(run.points.usable);
  completion.setPartialMesh(partial_mesh);
  completion.reconstruct(polygons);
  return run.control.cancelled() ||
         (areTriangles(polygons, run.point_count, run.loop()) &&
          (!partial_mesh || keepsTriangles(partial_mesh->polygons,
                                           completion.keptTriangles(),
                                           polygons,
                                           run.loop())));
}

} // namespace ccaa
} // namespace pcl
