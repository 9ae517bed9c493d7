// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: greedy triangulation extended to 3D (thesis 3.3).
#pragma once

#include <pcl/surface_ccaa/checked_construction.h>
#include <pcl/surface_ccaa/impl/triangle_handoff.h>
#include <pcl/surface_ccaa/reconstruction_parameters.h>
#include <pcl/surface_ccaa/reconstruction_report.h>
#include <pcl/surface_ccaa/run_settings.h>

#include <string>
#include <vector>

namespace pcl {

/** \brief The start algorithm of CCAA (thesis 3.3): the edges between neighboring
 * points, shortest first, each added unless it is incompatible with those before it;
 * three edges between three points make a triangle. Cheap, and with "a right of
 * mistake": UmbrellaFilter takes the mistakes out again.
 *
 * Needs neither normals nor any parameter, and works at any scale. The neighbors come
 * from the search method (PCL's KdTree when none is set); the class gives it the usable
 * points as its input. search::BlockSearch is several times faster than the others
 * because it is asked for all points at once.
 *
 * Triangles speak of cloud indices. Non-finite points get no triangle, and of several
 * points at one place only the one of lowest index does. No edge has more than two
 * triangles; windings are arbitrary. The result is the same for any number of threads.
 *
 * Stages of the progress callback: "neighbors", "edges", "second pass", "polygons".
 *
 * Cost O(N k^2) and about 250 bytes per point while it runs. One object serves one
 * thread at a time. Errors (PCL_ERROR, no triangles): a parameter out of range, an
 * index outside the cloud, fewer than three usable points, no cloud, a search method
 * for organised clouds with another one.
 *
 * \tparam PointT any point type with x, y and z of type float in a row
 */
template <typename PointT>
class GreedyStart : public ccaa::CheckedConstruction<PointT>,
                    public ccaa::RunSettings,
                    public ccaa::TakesHandoff {
public:
  using Ptr = shared_ptr<GreedyStart<PointT>>;
  using ConstPtr = shared_ptr<const GreedyStart<PointT>>;

  using MeshConstruction<PointT>::indices_;
  using MeshConstruction<PointT>::input_;
  using MeshConstruction<PointT>::tree_;

  GreedyStart();
  ~GreedyStart() override;

  /** \brief k: neighbors of a point between which edges are considered, 3 to 64.
   * Default 16. More find some more triangles on uneven samplings, at a price that
   * grows faster than k. Doubled where points in lines hardly see the next line. */
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

  /** \brief A_T: smallest angle between two edges at a point, in radians, 0 to pi/3.
   * Default 11 degrees. Edges that the empty-circle test certifies have a limit of
   * their own, see setCertifiedMinimumAngle(). */
  void
  setMinimumAngle(double angle)
  {
    parameters_.minimum_angle = angle;
  }
  double
  getMinimumAngle() const
  {
    return parameters_.minimum_angle;
  }

  /** \brief A_T for certified edges, in radians, 0 to pi/3. Default 1 degree: no other
   * point speaks against these edges, so they may form the thin triangles that an
   * uneven sampling asks for. Set it to A_T to have no thinner triangle at all. */
  void
  setCertifiedMinimumAngle(double angle)
  {
    parameters_.certified_minimum_angle = angle;
  }
  double
  getCertifiedMinimumAngle() const
  {
    return parameters_.certified_minimum_angle;
  }

  /** \brief Longest edge as a multiple of the local spacing, the root mean square
   * distance to the six nearest neighbors; the limit of either end counts. At least 1,
   * default 3. More for points in lines (see GreedyReport::line_gap). */
  void
  setLengthFactor(double factor)
  {
    parameters_.length_factor = factor;
  }
  double
  getLengthFactor() const
  {
    return parameters_.length_factor;
  }

  /** \brief Whether edges that pass the empty-circle test go first (default), or all
   * candidates compete by length and A_T alone, which is the plain algorithm of the
   * thesis. */
  void
  setUseCertificates(bool use)
  {
    parameters_.certificates = use;
  }
  bool
  getUseCertificates() const
  {
    return parameters_.certificates;
  }

  /** \brief Whether the uncertified candidates between points that are still open get
   * their turn after the certified ones. Default true. */
  void
  setSecondPass(bool second_pass)
  {
    parameters_.second_pass = second_pass;
  }
  bool
  getSecondPass() const
  {
    return parameters_.second_pass;
  }

  /** \brief Counts and seconds of the last run. */
  const ccaa::GreedyReport&
  getReport() const
  {
    return report_;
  }

protected:
  void
  performReconstruction(pcl::PolygonMesh& output) override;

  void
  performReconstruction(std::vector<pcl::Vertices>& polygons) override;

  std::string
  getClassName() const override
  {
    return "GreedyStart";
  }

private:
  ccaa::GreedyParameters parameters_;
  ccaa::GreedyReport report_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/surface_ccaa/impl/greedy_start.hpp>
#endif
