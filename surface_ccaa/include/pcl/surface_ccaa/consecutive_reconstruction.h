// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: consecutive application of algorithms (thesis 3.1).
#pragma once

#include <pcl/surface/processing.h>
#include <pcl/surface_ccaa/checked_construction.h>
#include <pcl/surface_ccaa/mesh_completion.h>
#include <pcl/surface_ccaa/reconstruction_report.h>
#include <pcl/surface_ccaa/run_settings.h>
#include <pcl/surface_ccaa/side_settings.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl {

namespace ccaa {
struct ChainInput;
struct ChainOutput;
} // namespace ccaa

/** \brief The concept of consecutive application of surface reconstruction algorithms
 * (CCAA, D3.1-1): a cheap start algorithm joins most of the cloud, with mistakes; a
 * filter takes the mistakes out; the base algorithm finishes what is left open.
 *
 * All three can be exchanged. Any MeshConstruction can start, also PCL's own, such as
 * GreedyProjectionTriangulation; any MeshProcessing that only leaves out triangles can
 * filter; any MeshCompletion can complete. The defaults, GreedyStart with
 * search::BlockSearch, UmbrellaFilter and a ProjectionCompletion that may replace
 * doubtful triangles (setKeepGiven(false)), need neither normals nor parameters.
 *
 * Chains may have more than one start algorithm: the first one gets the whole cloud;
 * each further one gets the points that are not yet inside of a surface, or, if it is a
 * MeshCompletion, all points and the triangles there are. What it makes and is not
 * there yet comes behind these, and the filter judges all of them again. If internal
 * points became fewer, the step is taken back.
 *
 * What the parts are given and what is expected from them:
 * - Threads and progress callback of this class go to every part that is a
 *   ccaa::RunSettings, for the time of the run. The stage is told as "start: edges",
 * the fraction is that of the whole chain.
 * - What is known about the outer side goes to every part that is a
 *   ccaa::SideSettings: what is told to this class, normals and viewpoints of the
 *   points, sensor_origin_ of the cloud, else the origin where the cloud lies before
 * it. Where nothing tells and the cloud is a terrain, up is guessed from its plane.
 *   getSideTally() says what it was.
 * - A search method, if one is set, goes to start and base algorithms; else each keeps
 *   its own.
 * - Start algorithms that are no ccaa::RunSettings get no indices, because not all of
 *   PCL's honour them: if points are to be left out they get a cloud of the others.
 * Only an organised cloud stays whole as far as its points that are not finite go.
 * - Polygons of a start algorithm that cannot be are left out and counted; those with
 *   more than three corners become fans.
 * - A filter may leave out triangles, turn them and change their order. Whatever it
 * does to the cloud has no effect.
 *
 * Triangles speak of cloud indices; those of earlier algorithms come first. Non-finite
 * points and points outside of the indices get none. The result is the same for any
 * number of threads if that is true of the parts.
 *
 * Errors (PCL_ERROR, no triangles): no cloud, a search method for organised clouds
 * with another one, a part is missing, an index outside the cloud,
 * fewer than three usable points, a filter that returns what it was not given, a base
 * algorithm that does not keep the given triangles, an exception from a part. If the
 * first start algorithm makes nothing (PCL_WARN), the others work alone. If the filter
 * leaves a one-sided region (PCL_WARN), the base algorithm does not run.
 *
 * The chain itself costs less than 0.15 us a point on one thread. One object serves one
 * thread at a time, and its parts are in use as long.
 *
 * \tparam PointT any point type with x, y and z of type float in a row
 */
template <typename PointT>
class ConsecutiveReconstruction : public ccaa::CheckedConstruction<PointT>,
                                  public ccaa::RunSettings,
                                  public ccaa::SideSettings {
public:
  using Ptr = shared_ptr<ConsecutiveReconstruction<PointT>>;
  using ConstPtr = shared_ptr<const ConsecutiveReconstruction<PointT>>;
  using StartPtr = typename MeshConstruction<PointT>::Ptr;
  using FilterPtr = MeshProcessing::Ptr;
  using BasePtr = typename MeshCompletion<PointT>::Ptr;

  using MeshConstruction<PointT>::indices_;
  using MeshConstruction<PointT>::input_;
  using MeshConstruction<PointT>::tree_;

  ConsecutiveReconstruction();
  ~ConsecutiveReconstruction() override;

  /** \brief Start with this algorithm alone. Default: GreedyStart with a
   * search::BlockSearch. */
  void
  setStartAlgorithm(const StartPtr& algorithm)
  {
    starts_.assign(1, algorithm);
  }

  /** \brief Put a further start algorithm behind those there are; at most 254. */
  void
  addStartAlgorithm(const StartPtr& algorithm)
  {
    starts_.push_back(algorithm);
  }
  const std::vector<StartPtr>&
  getStartAlgorithms() const
  {
    return starts_;
  }

  /** \brief What takes wrong triangles out after each start algorithm. Default:
   * UmbrellaFilter; null: nothing does. */
  void
  setFilter(const FilterPtr& filter)
  {
    filter_ = filter;
  }
  const FilterPtr&
  getFilter() const
  {
    return filter_;
  }

  /** \brief What completes the mesh. Default: ProjectionCompletion; null: nothing does,
   * the result is that of the last filter run. */
  void
  setBaseAlgorithm(const BasePtr& algorithm)
  {
    base_ = algorithm;
  }
  const BasePtr&
  getBaseAlgorithm() const
  {
    return base_;
  }

  /** \brief Whether a run also makes a normal for each point. Default false. */
  void
  setComputeNormals(bool compute)
  {
    compute_normals_ = compute;
  }
  bool
  getComputeNormals() const
  {
    return compute_normals_;
  }

  /** \brief Normals of the surface of the last run, one for each point of the cloud,
   * see ccaa::vertexNormals(); NaN at points without triangles. Null unless asked for
   * with setComputeNormals(). */
  PointCloud<Normal>::Ptr
  getNormals() const
  {
    return normals_;
  }

  /** \brief Which algorithm made each triangle of the last run, by its number in the
   * chain: 0 the (first) start algorithm, ..., the last one the base algorithm. */
  const std::vector<std::uint8_t>&
  getTriangleLabels() const
  {
    return labels_;
  }

  /** \brief Counts and seconds of the last run. */
  const ConsecutiveReport&
  getReport() const
  {
    return report_;
  }

  /** \brief Whether the chain pays on the input cloud (C3.1-1): run the base algorithm
   * alone, then the chain, and compare (T3.5-1). Labels, report and normals are those
   * of the chain's run afterwards. Errors (PCL_ERROR, a report of zeros): as for a run;
   * no base algorithm. */
  SpeedupReport
  measureSpeedup();

protected:
  void
  performReconstruction(pcl::PolygonMesh& output) override;

  void
  performReconstruction(std::vector<pcl::Vertices>& polygons) override;

  std::string
  getClassName() const override
  {
    return "ConsecutiveReconstruction";
  }

private:
  ccaa::ChainInput
  chainInput() const;

  void
  take(ccaa::ChainOutput result);

  std::vector<StartPtr> starts_;
  FilterPtr filter_;
  BasePtr base_;
  bool compute_normals_ = false;
  std::vector<std::uint8_t> labels_;
  PointCloud<Normal>::Ptr normals_;
  ConsecutiveReport report_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/surface_ccaa/impl/consecutive_reconstruction.hpp>
#endif
