// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: from islands and complex holes to one correct surface.

#pragma once

#include <pcl/surface/processing.h>
#include <pcl/surface_ccaa/run_settings.h>
#include <pcl/surface_repair/repair_parameters.h>
#include <pcl/surface_repair/repair_report.h>
#include <pcl/PCLPointCloud2.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pcl {
namespace ccaa {
struct LoopContext;
struct MeshView;
} // namespace ccaa
namespace repair {
struct Decisions;
struct ModelSurvey;
struct RepairedModel;
class WholeProgress;
} // namespace repair

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
 *
 * A mesh of any number of islands comes in. Holes are told from the rims of islands and
 * from the outer border of an open surface, islands are turned to the same side,
 * bridges join them, and the holes that are left are closed, refined and faired.
 * Nothing has to be set: lengths follow from the mesh. All options are in
 * repair::RepairParameters, with their defaults and ranges; the setters here write the
 * everyday ones of them, and getParameters() reads them.
 *
 * What goes in stays: the points of the cloud in order and bit for bit, all triangles
 * with their order, only wound the other way round where their island was. New points
 * are appended, their fields (colour, intensity, normals, ...) mixed from those of the
 * boundary near them. Points without a triangle are free points: samples of the missing
 * surface that draw it to themselves; where there are enough of them they become its
 * vertices. A mesh that is no manifold is cut where it is none; what that
 * costs is in the report.
 *
 * A cloud in map coordinates, with x, y and z as doubles (FLOAT64), is worked on near
 * the origin (pcl::GlobalShift; getReport().reading.global_shift tells the offset);
 * new points are doubles at the original place. Free points are in the same frame.
 *
 * The progress callback gets the share of the whole repair that is done, which never
 * falls, instead of that of a stage.
 *
 * The result is never worse than the input: a patch that would run through the surface
 * or through another one, or give an edge a third triangle, is made in another way or
 * left out, and the report says why. The result is the same for any number of threads.
 *
 * Errors (PCL_ERROR, no polygons, a report that is not complete()): an unreadable
 * cloud, no valid polygon, a parameter out of range, a search method for organised
 * clouds, memory. PCL's process() crashes without an input mesh, before this
 * class is asked. The input mesh itself may be given to process() as output.
 *
 * Cost: some 2 us a triangle for reading and orientation, 30 us a boundary edge and
 * 20 us a new vertex on one thread. One object serves one thread at a time.
 *
 * Progress: stages "reading", "orientation", "classification", "force lines",
 * "closing", which begins again as "closing, pass 2 of at most 5" when holes that were
 * left open are looked at once more.
 */
class ForceLineHoleRepair : public MeshProcessing, public ccaa::RunSettings {
public:
  using Ptr = shared_ptr<ForceLineHoleRepair>;
  using ConstPtr = shared_ptr<const ForceLineHoleRepair>;
  using SearchPtr = repair::PointSearchPtr;

  ForceLineHoleRepair();
  ~ForceLineHoleRepair() override;

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

  /** \brief All options at once. */
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

  /** \brief Search for the neighbourhoods of free points. Default: search::KdTree. */
  void
  setSearchMethod(const SearchPtr& search)
  {
    parameters_.survey.field.search = search;
  }
  const SearchPtr&
  getSearchMethod() const
  {
    return parameters_.survey.field.search;
  }

  /** \brief Where the sensor of all points stood, units of the cloud: goes before
   * normals and sensor positions of the cloud. Default: none. */
  void
  setViewpoint(const std::optional<Eigen::Vector3d>& position)
  {
    parameters_.survey.orientation.sides.told_viewpoint = position;
  }

  /** \brief Where the outer side looks, as that of a terrain does to the sky; of any
   * length. Asked after a viewpoint. Default: none. */
  void
  setUp(const std::optional<Eigen::Vector3d>& direction)
  {
    parameters_.survey.orientation.sides.up = direction;
  }

  /** \brief Whether the origin counts as the sensor's place where nothing says where it
   * stood and the mesh lies before it (see ccaa::liesBeforeOrigin()). Default false. */
  void
  setOriginAsViewpoint(bool allowed)
  {
    parameters_.survey.orientation.sides.try_origin = allowed;
  }

  /** \brief Light (M1) or full (M2), which takes about 4 times as long for the field.
   * Default LIGHT. */
  void
  setMode(repair::FieldMode mode)
  {
    parameters_.survey.field.mode = mode;
  }

  /** \brief k_i: how much more a boundary counts for places straight ahead of it. At
   * least 0, default 0. */
  void
  setInterpolation(double interpolation)
  {
    parameters_.survey.field.interpolation = interpolation;
  }

  /** \brief k_t: how far free points are to be trusted. In [0, 1), default 0.5; 0: they
   * do not count. */
  void
  setTrust(double trust)
  {
    parameters_.survey.field.trust = trust;
  }

  /** \brief How simple holes are closed. Default AUTOMATIC. */
  void
  setFillingMethod(repair::FillingChoice method)
  {
    parameters_.filling.choice = method;
  }

  /** \brief Edges up to which a hole is simple (D4.1-3) and is not divided. 0
   * (default): as many as the filling method can take. */
  void
  setSimpleHoleEdges(std::size_t edges)
  {
    parameters_.filling.simple_edges = edges;
  }
  std::size_t
  getSimpleHoleEdges() const
  {
    return parameters_.filling.simple_edges;
  }

  /** \brief Boundaries of more edges are left open. 0 (default): no limit. */
  void
  setGreatestHole(std::size_t edges)
  {
    parameters_.filling.greatest_hole = edges;
  }

  /** \brief Longer boundaries are left open: units of the cloud, or a share of the
   * bounding box' diagonal. 0 (default): no limit. */
  void
  setGreatestHoleLength(const repair::Extent& length)
  {
    parameters_.filling.greatest_length = length;
  }

  /** \brief Longer bridges between islands are not built: units of the cloud, or a
   * share of the bounding box' diagonal. 0 (default): no limit. */
  void
  setGreatestBridge(const repair::Extent& length)
  {
    parameters_.survey.greatest_bridge = length;
  }

  /** \brief Which boundaries are closed. Default HOLES. */
  void
  setClose(repair::CloseChoice choice)
  {
    parameters_.filling.close = choice;
  }

  /** \brief Whether a surface without any boundary is wanted: all that can be closed
   * is, and whatever stays open is a shortfall. Default false. */
  void
  setWatertight(bool watertight)
  {
    parameters_.watertight = watertight;
  }

  /** \brief Whether islands are joined. Default true; with false only holes are closed.
   */
  void
  setJoinIslands(bool join)
  {
    parameters_.join_islands = join;
  }

  /** \brief Whether patches get new vertices until they are as dense as what is around.
   * Default true; false, as in the thesis, also leaves out fairing. */
  void
  setRefinement(bool refine)
  {
    parameters_.refine = refine;
  }

  /** \brief Whether new vertices move to a smooth surface that joins the old one with
   * its tangent planes. Default true. */
  void
  setFairing(bool fair)
  {
    parameters_.relax = fair;
  }

  /** \brief What a user decided about boundaries and junctions of the input mesh. Null
   * (default): nothing. Decisions about another mesh are an error. */
  void
  setDecisions(const std::shared_ptr<const repair::Decisions>& decisions)
  {
    parameters_.survey.decisions = decisions;
  }

  /** \brief What a repair of the input mesh would do about its boundary loops and the
   * junctions between them, for a user to change. Given back as they are, decisions
   * change nothing.
   *
   * A loop that is to be joined to others, or of which it is not clear what it is, is
   * AUTO: closing or leaving it open is for the user to say. \code
   * auto decisions =
   *     std::make_shared<pcl::repair::Decisions>(repair.proposeDecisions());
   * decisions->loops[0].wish = pcl::repair::LoopWish::LEAVE_OPEN;
   * repair.setDecisions(decisions);
   * \endcode
   * Needs `pcl/surface_repair/decisions.h`. Errors (PCL_ERROR, nothing is proposed) as
   * for a repair, and no mesh. \return empty after an error and after cancelling */
  repair::Decisions
  proposeDecisions() const;

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
  /** \brief Where the input lies. The Python package has polygons in an array. */
  virtual ccaa::MeshView
  inputView() const;
  /** \brief Put triangles of vertices into the output, by the points of these; may take
   * them. */
  virtual void
  writeTriangles(std::vector<std::array<pcl::index_t, 3>>& triangles,
                 const std::vector<pcl::index_t>& point_of_vertex,
                 const ccaa::LoopContext& context,
                 pcl::PolygonMesh& output);
  bool
  checkParameters() const;
  bool
  read();
  bool
  isSound(const repair::ReadingReport& reading, const char* method) const;
  repair::Decisions
  propose() const;
  ccaa::ProgressCallback
  wholeProgress() const;
  void
  write(repair::RepairedModel& repaired, pcl::PolygonMesh& output);
  void
  reportOutOfMemory(const char* method) const;

  pcl::PCLPointCloud2::ConstPtr free_points_;
  repair::RepairParameters parameters_;
  RepairReport report_;
  std::shared_ptr<repair::ModelSurvey>
      survey_; /**< only between initCompute() and its end */
  std::shared_ptr<repair::WholeProgress> whole_; /**< likewise */
};

} // namespace pcl
