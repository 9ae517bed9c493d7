// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: from islands and complex holes to one correct surface.

#pragma once

#include <pcl/search/search.h>
#include <pcl/surface/processing.h>
#include <pcl/surface_ccaa/run_settings.h>
#include <pcl/surface_repair/repair_parameters.h>
#include <pcl/surface_repair/repair_report.h>
#include <pcl/PCLPointCloud2.h>
#include <pcl/point_types.h>

#include <memory>
#include <string>

namespace pcl {
namespace repair {
struct RepairedModel;
}

/** \brief Repairs an incomplete model: joins its islands by bridges along force lines
 * and closes the holes between them (thesis, Chapter 4).
 *
 * \code
 * pcl::ForceLineHoleRepair repair;
 * repair.setInputMesh(mesh);
 * pcl::PolygonMesh repaired;
 * repair.process(repaired);
 * for (const auto& hole : repair.getReport().holes)
 *   if (pcl::isShortfall(hole.open))
 *     std::cerr << pcl::describe(hole.open) << "\n";
 * \endcode
 */
class ForceLineHoleRepair : public MeshProcessing, public ccaa::RunSettings {
public:
  using Ptr = shared_ptr<ForceLineHoleRepair>;
  using ConstPtr = shared_ptr<const ForceLineHoleRepair>;
  using SearchPtr = pcl::search::Search<pcl::PointXYZ>::Ptr;

  /** \brief Samples of the missing regions, beside the points of the mesh that have no
   * triangle. Null (default): none. Such a point that becomes a vertex is appended. */
  void
  setFreePoints(const pcl::PCLPointCloud2::ConstPtr& cloud)
  {
    free_points_ = cloud;
  }
  const pcl::PCLPointCloud2::ConstPtr&
  getFreePoints() const
  {
    return free_points_;
  }

  /** \brief Search for the neighbourhoods of free points. Default: search::KdTree. */
  void
  setSearchMethod(const SearchPtr& search)
  {
    search_ = search;
  }
  const SearchPtr&
  getSearchMethod() const
  {
    return search_;
  }

  /** \brief All parameters at once. */
  void
  setParameters(const repair::RepairParameters& parameters)
  {
    parameters_ = parameters;
  }
  const repair::RepairParameters&
  getParameters() const
  {
    return parameters_;
  }

  /** \brief Light (M1) or full (M2). Default LIGHT. */
  void
  setMode(repair::FieldMode mode)
  {
    parameters_.survey.field.mode = mode;
  }
  repair::FieldMode
  getMode() const
  {
    return parameters_.survey.field.mode;
  }

  /** \brief What the last run found and did. */
  const RepairReport&
  getReport() const
  {
    return report_;
  }

protected:
  bool
  initCompute() override;
  void
  performProcessing(pcl::PolygonMesh& output) override;
  void
  deinitCompute() override;
  std::string
  getClassName() const override
  {
    return "ForceLineHoleRepair";
  }

private:
  bool
  checkParameters() const;
  bool
  run();
  void
  write(pcl::PolygonMesh& output);
  void
  reportOutOfMemory(const char* method) const;

  pcl::PCLPointCloud2::ConstPtr free_points_;
  SearchPtr search_;
  repair::RepairParameters parameters_;
  RepairReport report_;
  std::shared_ptr<repair::RepairedModel>
      repaired_; /**< only between initCompute() and its end */
};

} // namespace pcl
