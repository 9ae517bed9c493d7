// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what the templates on clouds call of the compiled code.
#pragma once

#include <pcl/surface_ccaa/impl/point_array.h>
#include <pcl/surface_ccaa/impl/triangle_handoff.h>
#include <pcl/surface_ccaa/reconstruction_parameters.h>
#include <pcl/surface_ccaa/reconstruction_report.h>
#include <pcl/surface_ccaa/run_settings.h>
#include <pcl/surface_ccaa/side_settings.h>
#include <pcl/pcl_base.h> // for IndicesPtr
#include <pcl/PolygonMesh.h>
#include <pcl/types.h>
#include <pcl/Vertices.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace pcl {

class MeshProcessing;
struct Normal;
template <typename PointT>
class PointCloud;

namespace ccaa {

class PointBlocks;

/** \brief A search method of PCL with the cloud that it searches. */
struct TreeSearch {
  /** \brief From now on search among these points of the cloud. */
  std::function<void(const IndicesPtr& chosen)> hold;
  /** \brief The nearest of them to a point of the cloud; from several threads. */
  std::function<void(
      index_t point, int k, Indices& near, std::vector<float>& sqr_distances)>
      nearest;
  /** \brief Of a search::BlockSearch, which finds the neighbors of all points at once;
   * else null. */
  const PointBlocks* blocks = nullptr;
};

/** \brief What any run on a cloud is given. All must outlive the run. */
struct CloudInput {
  PointArray points;
  IndicesPtr selection;      /**< points that may be used, not looked at yet */
  unsigned int threads = 0;  /**< 0: all */
  ProgressCallback progress; /**< may be empty */
  /** \brief Takes the place of the polygons that are given and come out; null: none. */
  TriangleHandoff* handoff = nullptr;
};

/** \brief GreedyStart on the points of a cloud, whatever their type.
 * \param[in] search for the neighbors
 * \param[out] polygons of cloud indices
 * \return why there is no result, without a full stop; empty if there is one, and after
 * cancelling */
std::string
runGreedyStart(const CloudInput& input,
               const TreeSearch& search,
               const GreedyParameters& parameters,
               GreedyReport& report,
               std::vector<pcl::Vertices>& polygons);

/** \brief What a completion is made from, beside the points. */
struct CompletionInput : CloudInput {
  PointArray normals;    /**< same size, or empty; outward, of any length, may be NaN */
  PointArray viewpoints; /**< same size, or empty: sensor positions */
  SideHints sides;       /**< what is told for the whole cloud */
  const PolygonMesh* partial_mesh = nullptr; /**< triangles to keep, or null */
  IndicesConstPtr cut_points;                /**< see MeshCompletion; null: none */
  const TreeSearch* search = nullptr;        /**< null: PointBlocks, the fastest */
};

/** \brief What came of it. */
struct CompletionOutput {
  std::vector<pcl::Vertices>
      polygons;              /**< the given ones that stay, then the new ones */
  std::vector<index_t> kept; /**< which of the given triangles, ascending */
  std::string error;         /**< why there is no result, without a full stop */
};

/** \brief ProjectionCompletion on the points of a cloud, whatever their type. Polygons
 * with more than three corners become fans. Points that are not finite, and all but one
 * of several points at one place, get no new triangle; those of the given triangles are
 * used whatever the selection says. */
CompletionOutput
runCompletion(const CompletionInput& input,
              const CompletionParameters& parameters,
              CompletionReport& report);

/** \brief Points that a start algorithm of a chain may use, all of them finite. */
struct ChainSelection {
  IndicesPtr chosen;     /**< cloud indices */
  bool is_part = false;  /**< some finite points are not among them, or the order is
                              another one than in the cloud */
  bool has_gaps = false; /**< the cloud has points that are not finite */
};

/** \brief What a chain sets in each of its stages and puts back at the end. */
struct StageSettings {
  /** \brief Those of any algorithm, ours or another's. */
  template <typename Algorithm>
  static StageSettings
  of(Algorithm* algorithm)
  {
    return {dynamic_cast<RunSettings*>(algorithm),
            dynamic_cast<SideSettings*>(algorithm)};
  }

  RunSettings* run;    /**< null: it has none, and need not honour indices */
  SideSettings* sides; /**< null: it is told nothing */
};

/** \brief What an algorithm of a chain makes. */
struct StageOutput {
  TriangleHandoff handoff;             /**< of an algorithm that takes part in it */
  std::vector<pcl::Vertices> polygons; /**< of another one; not checked */
};

/** \brief One algorithm of a chain, whatever its point type. */
class ChainPart {
public:
  virtual ~ChainPart() = default;

  virtual StageSettings
  settings() const = 0;
  /** \brief Whether it hands triangles over, and can be given them. */
  virtual bool
  takesHandoff() const = 0;
  /** \brief Whether it is a MeshCompletion. */
  virtual bool
  completes() const = 0;
  /** \brief See MeshCompletion::keptTriangles(). */
  virtual const std::vector<index_t>*
  keptTriangles() const = 0;
  /** \brief See MeshCompletion::topologyDoubts(). */
  virtual TopologyDoubts
  topologyDoubts() const
  {
    return {};
  }

  /** \brief Start from points alone.
   * \return whether its polygons speak of places in the selection and not of points of
   * the cloud */
  virtual bool
  construct(const ChainSelection& points, StageOutput& made) = 0;

  /** \brief Complete a mesh. \param[in] partial_mesh null: there is none, or it is
   * handed over \param[in,out] made of cloud indices */
  virtual void
  complete(const PolygonMeshConstPtr& partial_mesh,
           const IndicesPtr& usable,
           StageOutput& made) = 0;
};

/** \brief A chain and what it is applied to. */
struct ChainInput : CloudInput {
  bool has_viewpoints = false; /**< each point has a sensor position */
  SideHints sides;             /**< what is told for the whole cloud */
  std::vector<std::shared_ptr<ChainPart>> starts; /**< null ones are an error */
  MeshProcessing* filter = nullptr;               /**< null: nothing filters */
  std::shared_ptr<ChainPart> base;                /**< null: nothing completes */
  bool compute_normals = false;
  std::function<void(PCLPointCloud2&)> write_cloud; /**< where the output has none */
};

/** \brief What came of it, beside the polygons. */
struct ChainOutput {
  std::vector<std::uint8_t> labels; /**< of the triangles */
  std::shared_ptr<PointCloud<Normal>> normals;
  ConsecutiveReport report;
  SideTally sides;
};

/** \brief ConsecutiveReconstruction on the points of a cloud, whatever their type.
 * Errors are told (PCL_ERROR) and leave no polygons.
 * \param[in] has_cloud the output holds the cloud, which stays
 * \param[in,out] output its polygons are the result */
void
runChain(const ChainInput& input,
         bool has_cloud,
         pcl::PolygonMesh& output,
         ChainOutput& result);

/** \brief The base algorithm alone, then the chain.
 * \param[out] result of the chain */
SpeedupReport
measureChain(const ChainInput& input, ChainOutput& result);

} // namespace ccaa
} // namespace pcl
