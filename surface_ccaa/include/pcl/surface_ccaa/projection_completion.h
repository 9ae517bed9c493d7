// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the base algorithm of CCAA (thesis 3.1, 3.5).
#pragma once

#include <pcl/surface_ccaa/impl/triangle_handoff.h>
#include <pcl/surface_ccaa/mesh_completion.h>
#include <pcl/surface_ccaa/reconstruction_parameters.h>
#include <pcl/surface_ccaa/reconstruction_report.h>

#include <string>
#include <vector>

namespace pcl {

/** \brief The base algorithm of CCAA: starts from given triangles with their boundaries
 * and free points, keeps the triangles and adds what is missing; without given
 * triangles it is a surface reconstruction by itself.
 *
 * The surface grows from the boundaries, the triangle that the samples support best
 * first. A triangle must find its place in the angular order of the fans at its
 * corners, seen in their tangent planes (after Gopi and Krishnan 2002), and its
 * smallest empty ball tells how well it is supported. It must neither cross the surface
 * nor overfill an edge, so that the result is manifold and orientable by construction.
 * Gaps that growth leaves are closed as a whole. See
 * doc/concepts/advancing_front.md.
 *
 * A gap without samples that is wide against their spacing stays open: a real hole or
 * the border of the object. Points scattered in space stay free points. Outward
 * normals, sensor positions (vp_x, ... or sensor_origin_) and what is told (see
 * ccaa::SideSettings) are used, but not needed: islands are not turned against them.
 * Triangles speak of cloud indices; non-finite points and repeated places get none. The
 * result is the same for any number of threads; growth itself runs on one.
 *
 * Cost: 0.5 us a given point, 15 us an open one. Errors (PCL_ERROR, no triangles): a
 * parameter out of range, an index outside the cloud, fewer than three usable points, a
 * partial mesh of another cloud, with corners out of range, non-manifold or wound
 * inconsistently, no cloud, a search method for organised clouds with another one. One
 * object serves one thread at a time.
 *
 * \tparam PointT any point type with x, y and z of type float in a row
 */
template <typename PointT>
class ProjectionCompletion : public MeshCompletion<PointT>, public ccaa::TakesHandoff {
public:
  using Ptr = shared_ptr<ProjectionCompletion<PointT>>;
  using ConstPtr = shared_ptr<const ProjectionCompletion<PointT>>;

  using MeshCompletion<PointT>::cut_points_;
  using MeshCompletion<PointT>::indices_;
  using MeshCompletion<PointT>::input_;
  using MeshCompletion<PointT>::partial_mesh_;
  using MeshCompletion<PointT>::progress_;
  using MeshCompletion<PointT>::side_hints_;
  using MeshCompletion<PointT>::side_tally_;
  using MeshCompletion<PointT>::threads_;
  using MeshCompletion<PointT>::tree_;

  ProjectionCompletion();
  ~ProjectionCompletion() override;

  /** \brief Whether every given triangle stays (default), or those that look wrong or
   * stand in the way may be replaced (see ccaa::doubtfulTriangles()).
   * keptTriangles() tells which stayed. */
  void
  setKeepGiven(bool keep)
  {
    parameters_.keep_given = keep;
  }
  bool
  getKeepGiven() const
  {
    return parameters_.keep_given;
  }

  /** \brief Open points around an open point among which its triangles are sought, 6 to
   * 64. Default 20. */
  void
  setNumberOfNeighbors(unsigned int neighbors)
  {
    parameters_.neighbors = neighbors;
  }
  unsigned int
  getNumberOfNeighbors() const
  {
    return parameters_.neighbors;
  }

  /** \brief Largest circumradius of a new triangle in local spacings, 0.5 to 100.
   * Default 2. Larger closes wider gaps. */
  void
  setSupport(double support)
  {
    parameters_.support = support;
  }
  double
  getSupport() const
  {
    return parameters_.support;
  }

  /** \brief Angle between the normals of neighboring triangles, in radians, up to which
   * the surface counts as smooth and grows first, 0 to pi. Default 30 degrees. */
  void
  setSmoothFold(double angle)
  {
    parameters_.smooth_fold = angle;
  }
  double
  getSmoothFold() const
  {
    return parameters_.smooth_fold;
  }

  /** \brief Largest angle between the normals of neighboring triangles, in radians, 0
   * to pi. Default 150 degrees. */
  void
  setLargestFold(double angle)
  {
    parameters_.largest_fold = angle;
  }
  double
  getLargestFold() const
  {
    return parameters_.largest_fold;
  }

  /** \brief N_i of C3.4-3: a region that grew apart from the given ones stays only with
   * so many internal points. Default 10. */
  void
  setMinimumInternalPoints(std::size_t count)
  {
    parameters_.minimum_internal_points = count;
  }
  std::size_t
  getMinimumInternalPoints() const
  {
    return parameters_.minimum_internal_points;
  }

  /** \brief Counts and seconds of the last run. */
  const ccaa::CompletionReport&
  getReport() const
  {
    return report_;
  }

  const std::vector<index_t>*
  keptTriangles() const override
  {
    return parameters_.keep_given ? nullptr : &kept_;
  }

  /** \brief All handles, where the ends of an edge face away from each other (normals
   * more than 107 degrees apart). None where given triangles are kept. */
  TopologyDoubts
  topologyDoubts() const override
  {
    return report_.doubts;
  }

protected:
  void
  performReconstruction(pcl::PolygonMesh& output) override;

  void
  performReconstruction(std::vector<pcl::Vertices>& polygons) override;

  std::string
  getClassName() const override
  {
    return "ProjectionCompletion";
  }

private:
  ccaa::CompletionParameters parameters_;
  ccaa::CompletionReport report_;
  std::vector<index_t> kept_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/surface_ccaa/impl/projection_completion.hpp>
#endif
