// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: keeps only the correct triangles of any mesh (thesis 3.4).
#pragma once

#include <pcl/surface/processing.h>
#include <pcl/surface_ccaa/impl/triangle_handoff.h>
#include <pcl/surface_ccaa/run_settings.h>
#include <pcl/surface_ccaa/side_settings.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace pcl {
namespace ccaa {
class FilterRun;
}

/** \brief What a point is after the filter (table T3.4-1). */
enum class PointRole : std::uint8_t {
  FREE,     /**< no triangle */
  BOUNDARY, /**< one open chain of triangles */
  INTERNAL  /**< one closed chain of triangles */
};

/** \brief What one run of UmbrellaFilter found and removed. */
struct UmbrellaReport {
  std::size_t input_polygons = 0; /**< polygons given */
  std::size_t invalid_polygons =
      0; /**< index out of range, repeated or non-finite corner */
  std::size_t duplicate_triangles = 0; /**< the same three corners once more */
  std::size_t overfull_edges = 0; /**< edges with three or more triangles (C3.4-1) */
  std::size_t overfull_triangles = 0;     /**< triangles it cost to repair them */
  std::size_t umbrella_triangles = 0;     /**< removed by rows 3, 4 and 5 of T3.4-1 */
  std::size_t small_region_triangles = 0; /**< removed by C3.4-3 */
  std::size_t twist_triangles = 0; /**< removed because they turned a region over */
  std::size_t output_triangles = 0;
  std::size_t reversed_triangles = 0; /**< triangles whose winding was turned round */
  std::size_t components = 0;         /**< regions kept */
  std::size_t one_sided_components =
      0; /**< regions that cannot be oriented (kept as they are) */
  std::size_t internal_points = 0;
  std::size_t boundary_points = 0;
  std::size_t free_points = 0;
  bool cancelled = false;
};

/** \brief Umbrella filtering: whatever mesh goes in, a certified incomplete normalised
 * CAD model (ICADM, D1.3-1) comes out: every point that still has triangles has exactly
 * one chain of them, no edge has more than two, and all other points of the cloud are
 * free points. Filtering the result once more changes nothing.
 *
 * The filter creates nothing and moves nothing: the output cloud is the input cloud,
 * byte for byte, and the output polygons are input triangles in input order (polygons
 * with more than three corners enter as fans around their first corner). Input that
 * breaks C3.4-1, with three or more triangles on an edge, is repaired first (see
 * ccaa::repairNonManifoldEdges()). Then table T3.4-1 is applied until nothing changes,
 * and regions that are too small to be trusted go altogether (C3.4-3). What is left is
 * wound consistently, outward where that can be told (see ccaa::orientTriangles(),
 * which uses normals and sensor positions if the cloud has them, and before these what
 * the user tells: see ccaa::SideSettings).
 *
 * The result does not depend on the number of threads, nor on the order of points or
 * polygons (for ties see ccaa::survivingChain()).
 *
 * On an unreadable cloud (PCL_ERROR) and on cancelling, polygons and roles are empty.
 * Invalid polygons (PCL_WARN) are left out. The input mesh itself may be given to
 * process() as output; its old polygons are then lost in any case. PCL's process()
 * crashes without an input mesh, before this class is asked.
 *
 * Cost: linear in the number of triangles; without orientation about 0.25 us a point
 * with two triangles on one thread, and up to 150 bytes a point besides input and
 * output. One object serves one thread at a time; const getters may be called from
 * several.
 */
class UmbrellaFilter : public MeshProcessing,
                       public ccaa::RunSettings,
                       public ccaa::SideSettings,
                       public ccaa::TakesHandoff {
public:
  using Ptr = shared_ptr<UmbrellaFilter>;
  using ConstPtr = shared_ptr<const UmbrellaFilter>;

  /** \brief N_i of C3.4-3: a region with fewer internal points goes altogether.
   * 0 keeps every region. Default 10. Set it to 0 where small separate parts are
   * wanted, higher where strays form crumbs. */
  void
  setMinimumInternalPoints(std::size_t count)
  {
    minimum_internal_points_ = count;
  }
  std::size_t
  getMinimumInternalPoints() const
  {
    return minimum_internal_points_;
  }

  /** \brief Wind all triangles of a region alike, and outward where that can be told
   * (see mesh/orientation.h). Default true; with false the windings of the input stay.
   * Set it false where these are right though they look inward. */
  void
  setConsistentOrientation(bool orient)
  {
    consistent_orientation_ = orient;
  }
  bool
  getConsistentOrientation() const
  {
    return consistent_orientation_;
  }

  /** \brief Largest share of a one-sided region's triangles that may go to make it
   * two-sided, 0 to 1 (see ccaa::findTwists()). Default 0.1; 0 leaves one-sided regions
   * as they are. Without consistent orientation nothing is cut. Set it to 0 for objects
   * that have one side only, such as a Moebius band. */
  void
  setLargestTwistShare(double share)
  {
    largest_twist_share_ = share;
  }
  double
  getLargestTwistShare() const
  {
    return largest_twist_share_;
  }

  /** \brief Role of each point of the cloud after the last run, in cloud order. */
  const std::vector<PointRole>&
  getPointRoles() const
  {
    return roles_;
  }

  /** \brief Counts of the last run. */
  const UmbrellaReport&
  getReport() const
  {
    return report_;
  }

protected:
  bool
  initCompute() override;

  void
  performProcessing(pcl::PolygonMesh& output) override;

  std::string
  getClassName() const override
  {
    return "UmbrellaFilter";
  }

  void
  deinitCompute() override;

private:
  bool
  checkInput() const;
  void
  readInput();
  void
  filter(pcl::PolygonMesh& output);
  void
  clearResult(pcl::PolygonMesh& output);
  void
  reportOutOfMemory(const char* method) const;

  std::size_t minimum_internal_points_ = 10;
  bool consistent_orientation_ = true;
  double largest_twist_share_ = 0.1;
  std::vector<PointRole> roles_;
  UmbrellaReport report_;
  std::shared_ptr<ccaa::FilterRun> run_; /**< only between initCompute() and its end */
};

} // namespace pcl
