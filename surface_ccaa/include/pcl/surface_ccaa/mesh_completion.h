// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the contract of base algorithms (thesis 3.1, 3.5).
#pragma once

#include <pcl/surface_ccaa/checked_construction.h>
#include <pcl/surface_ccaa/reconstruction_report.h>
#include <pcl/surface_ccaa/run_settings.h>
#include <pcl/surface_ccaa/side_settings.h>
#include <pcl/pcl_base.h> // for IndicesConstPtr
#include <pcl/PolygonMesh.h>

#include <cstddef>
#include <vector>

namespace pcl {

/** \brief A base algorithm of CCAA (D3.1-1): a surface from a cloud *and the triangles
 * that are there already*. It keeps every one of them and adds what is missing between
 * their boundaries and the free points.
 *
 * The contract, which ConsecutiveReconstruction relies on and checks:
 * - The triangles of the partial mesh speak of points of the input cloud, also when
 *   indices are set. They form an ICADM (D1.3-1), as UmbrellaFilter makes it. Of the
 *   cloud the partial mesh carries only the size is looked at.
 * - The result begins with these triangles, in their order; only their winding may
 *   differ, when the surface they belong to was turned over as a whole. The new
 *   triangles follow. All speak of cloud indices. An algorithm that was allowed to
 *   replace given triangles says in keptTriangles() which stayed.
 * - New triangles use points among the indices and points of the given triangles.
 * - Without a partial mesh, or with one without polygons, the result is a
 *   reconstruction from the cloud alone: algorithm A of thesis 3.1.
 * - A partial mesh that does not belong to the cloud (corner out of range, edge with
 *   three triangles, point with two fans): PCL_ERROR and no polygons.
 * - An algorithm that winds triangles goes by what it is told (ccaa::SideSettings), by
 *   normals and by sensor positions, and does not turn what they say.
 * - As everywhere in this library: non-finite points get no triangle, threads change
 *   nothing but the time, cancelling leaves no polygons.
 *
 * An own base algorithm derives from this class and overrides both
 * performReconstruction(); it needs no search tree of the base class.
 *
 * \tparam PointT any point type with x, y and z of type float in a row
 */
template <typename PointT>
class MeshCompletion : public ccaa::CheckedConstruction<PointT>,
                       public ccaa::RunSettings,
                       public ccaa::SideSettings {
public:
  using Ptr = shared_ptr<MeshCompletion<PointT>>;
  using ConstPtr = shared_ptr<const MeshCompletion<PointT>>;

  MeshCompletion() { side_hints_.try_origin = true; }

  /** \brief The triangles to keep; null (the default) for none. The mesh is not copied:
   * it must not change during a run. */
  void
  setPartialMesh(const PolygonMeshConstPtr& mesh)
  {
    partial_mesh_ = mesh;
  }
  PolygonMeshConstPtr
  getPartialMesh() const
  {
    return partial_mesh_;
  }

  /** \brief Points at which the surface goes on outside of what is given, such as those
   * where a cloud was cut into tiles, by their cloud indices: nothing grows from them,
   * and what is open there is neither closed nor removed as small. Points without
   * triangles among them stay free. Null (the default) for none. An index outside the
   * cloud is an error (PCL_ERROR, no polygons). */
  void
  setCutPoints(const IndicesConstPtr& points)
  {
    cut_points_ = points;
  }
  IndicesConstPtr
  getCutPoints() const
  {
    return cut_points_;
  }

  /** \brief After a run: with which triangles of the partial mesh the result begins, by
   * their numbers, ascending. Null (the default): with all of them, as the contract
   * says. For algorithms that were allowed to replace given triangles. */
  virtual const std::vector<index_t>*
  keptTriangles() const
  {
    return nullptr;
  }

  /** \brief After a run: where its result may be wrong about what is connected. None
   * where the algorithm does not know. */
  virtual TopologyDoubts
  topologyDoubts() const
  {
    return {};
  }

protected:
  PolygonMeshConstPtr partial_mesh_;
  IndicesConstPtr cut_points_;
};

} // namespace pcl
