// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what each boundary of a mesh bounds: hole, rim or border.

#pragma once

#include <pcl/surface_ccaa/run_settings.h>
#include <pcl/surface_repair/model_findings.h>
#include <pcl/surface_repair/repair_parameters.h>
#include <pcl/memory.h>
#include <pcl/PolygonMesh.h>
#include <pcl/types.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl {
namespace repair {
struct IncompleteModel;
}

/** \brief One boundary loop of a mesh and what it bounds. */
struct ClassifiedBoundary {
  /** \brief Points of the cloud along the loop, the surface on the left. */
  pcl::Indices vertices;
  repair::BoundaryClass boundary_class = repair::BoundaryClass::UNDECIDED;
  double confidence = 0.0;       /**< of the class, 0 to 1 */
  repair::LoopEvidence evidence; /**< D (D4.1-1) and what else speaks for the class */
  double faced = 0.0;            /**< share of a rim that other islands face, 0 to 1 */
  std::size_t island = 0;        /**< islands count by their first polygon */
  double length = 0.0;           /**< units of the cloud */
};

/** \brief What one run of BoundaryClassifier found. */
struct BoundaryReport {
  repair::ReadingReport reading; /**< what had to change before boundaries could be
                                      walked */
  std::size_t triangles = 0;
  std::size_t free_points = 0;
  std::size_t one_sided_islands = 0;
  std::size_t island_rims = 0;
  std::size_t outer_borders = 0;
  std::size_t undecided = 0;
  repair::IcmCounts counts;                            /**< islands and holes */
  repair::IcmClass icm_class = repair::IcmClass::ICM1; /**< by these (D4.1-4) */
};

/** \brief Tells for every boundary loop of a mesh whether it bounds a hole, an island
 * of the surface, or the surface as a whole.
 *
 * \code
 * pcl::BoundaryClassifier classifier;
 * classifier.setInputMesh(mesh);
 * std::vector<pcl::ClassifiedBoundary> boundaries;
 * if (classifier.classify(boundaries))
 *   for (const auto& boundary : boundaries)
 *     if (boundary.boundary_class == pcl::repair::BoundaryClass::HOLE)
 *       close(boundary.vertices);
 * \endcode
 *
 * The question is that of thesis 4.1, and the boundary integral D (D4.1-1) is the first
 * witness; see repair::classifyBoundaries() for the others and for what a confidence
 * means. Where nothing is clear, as at the mouths of a tube, the answer is UNDECIDED.
 *
 * Any mesh may come in. One that is manifold and consistently wound is taken as it is;
 * another one is cut where it is none, and getReport().reading says what that
 * has cost. The mesh itself is never changed. The result is the same for any number of
 * threads.
 *
 * Errors (PCL_ERROR, classify() returns false, no boundaries): no mesh, an unreadable
 * cloud, no valid polygon, a parameter out of range. A closed mesh is none: there are
 * just no boundaries. Cost: about 0.6 us a triangle and 3 us a boundary edge. One
 * object serves one thread at a time.
 *
 * Progress: stages "reading" and "boundaries".
 */
class BoundaryClassifier : public ccaa::RunSettings {
public:
  using Ptr = shared_ptr<BoundaryClassifier>;
  using ConstPtr = shared_ptr<const BoundaryClassifier>;

  void
  setInputMesh(const pcl::PolygonMesh::ConstPtr& mesh)
  {
    input_mesh_ = mesh;
  }
  const pcl::PolygonMesh::ConstPtr&
  getInputMesh() const
  {
    return input_mesh_;
  }

  /** \brief Least confidence of a class; below it the answer is UNDECIDED. 0 to 1,
   * default 0.4. Set it higher where a wrong class costs more than an open question. */
  void
  setMinimumConfidence(double confidence)
  {
    parameters_.decided_from = confidence;
  }
  double
  getMinimumConfidence() const
  {
    return parameters_.decided_from;
  }

  /** \brief Share of a rim that must be faced by other islands before it counts as
   * ISLAND_RIM and not as OUTER_BORDER. 0 to 1, default 0.25. Set it lower where
   * islands lie side by side and their rims count as outer borders. */
  void
  setMinimumFacedShare(double share)
  {
    parameters_.faced_from = share;
  }
  double
  getMinimumFacedShare() const
  {
    return parameters_.faced_from;
  }

  /** \brief Edges up to which a hole counts as simple (D4.1-3). Default 12, for the
   * fan of thesis 4.7. Set it higher where your own filling takes larger ones. */
  void
  setSimpleHoleEdges(std::size_t edges)
  {
    simple_hole_edges_ = edges;
  }
  std::size_t
  getSimpleHoleEdges() const
  {
    return simple_hole_edges_;
  }

  /** \brief Find and classify all boundaries, in the order of their first polygon.
   * \param[out] boundaries empty when false is returned, or when the mesh is closed
   * \return false after an error and after cancelling */
  bool
  classify(std::vector<ClassifiedBoundary>& boundaries);

  /** \brief Counts of the last run. */
  const BoundaryReport&
  getReport() const
  {
    return report_;
  }

private:
  bool
  checkParameters() const;
  bool
  run(std::vector<ClassifiedBoundary>& boundaries);
  void
  count(const repair::IncompleteModel& model,
        const std::vector<ClassifiedBoundary>& boundaries);

  pcl::PolygonMesh::ConstPtr input_mesh_;
  repair::ClassificationParameters parameters_;
  std::size_t simple_hole_edges_ = repair::SIMPLE_HOLE_EDGES;
  BoundaryReport report_;
};

} // namespace pcl
