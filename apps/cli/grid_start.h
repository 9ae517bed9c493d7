// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the grid of an organised cloud as the start of a chain.
#pragma once

#include <pcl/surface/impl/organized_fast_mesh.hpp>
#include <pcl/surface_ccaa/impl/consecutive_reconstruction.hpp>

#include <cmath>
#include <memory>
#include <vector>

namespace app {

/** \brief Steeper edges than this join a thing with what lies behind it; the angle is
 * between the edge and the ray of the sensor. */
constexpr double LEAST_RAY_ANGLE = 5.0 * M_PI / 180;

/** \brief Triangles between neighbours in rows and columns, but not across jumps of
 * depth; \a sensor in the frame of the cloud. */
template <typename PointT>
std::shared_ptr<pcl::MeshConstruction<PointT>>
makeGridStart(const Eigen::Vector3d& sensor)
{
  using Grid = pcl::OrganizedFastMesh<PointT>;
  auto grid = std::make_shared<Grid>();
  grid->setTriangulationType(Grid::TRIANGLE_ADAPTIVE_CUT);
  grid->setViewpoint(sensor.cast<float>());
  grid->storeShadowedFaces(false);
  grid->setAngleTolerance(static_cast<float>(LEAST_RAY_ANGLE));
  return grid;
}

/** \brief Into how many islands what a start algorithm makes and the filter keeps
 * falls. \a chain has its input, filter and settings; its algorithms are set. */
template <typename PointT>
std::size_t
islandsAfter(const std::shared_ptr<pcl::MeshConstruction<PointT>>& start,
             const pcl::UmbrellaFilter& filter,
             pcl::ConsecutiveReconstruction<PointT>& chain)
{
  const auto base = chain.getBaseAlgorithm();
  chain.setStartAlgorithm(start);
  chain.setBaseAlgorithm(nullptr);
  std::vector<pcl::Vertices> triangles;
  chain.reconstruct(triangles);
  chain.setBaseAlgorithm(base);
  return triangles.empty() ? std::size_t(-1) : filter.getReport().components;
}

} // namespace app
