// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: all that can be told about an incomplete model.

#pragma once

#include <pcl/surface_repair/repair_parameters.h>
#include <pcl/PCLPointCloud2.h>
#include <pcl/PolygonMesh.h>

#include "boundary/classification.h"
#include "decision/loop_wishes.h"
#include "field/free_point_field.h"
#include "field/shielding.h"
#include "force_line/line_origins.h"
#include "hole/hole_contour.h"
#include "icadm/fins.h"
#include "icadm/icm_class.h"
#include "icadm/island_dropping.h"
#include "icadm/model_reading.h"
#include "junction/junction.h"
#include "mesh/block_loop.h"
#include "orientation/island_orientation.h"
#include "perturbation/free_point_perturbation.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace pcl::repair {

/** \brief Force lines of one step of the method: between islands, or within one hole.
 */
struct SurveyedField {
  std::size_t hole = NONE;             /**< the loop, for lines within a hole */
  std::vector<PossibleOrigin> origins; /**< at every source that something reaches */
  std::vector<ForceLine> lines;        /**< traced from the strongest origins */
};

/** \brief What would join the islands: the bridges chosen among the lines between them,
 * and the contours of the holes that are left then (4.47). Boundaries that are no
 * sources (C4.46-1) are not among the curves. */
struct SurveyedBridges {
  std::vector<std::size_t>
      loops; /**< of the curves that bridges and contours refer to */
  std::vector<Junction> junctions; /**< what lines connect, of the same curves */
  std::vector<Bridge> bridges;     /**< only of junctions that are joined */
  ContourExtraction holes;
  std::vector<std::size_t> ahead;   /**< of each loop of the model that is the mouth of
                                       a tube: one of its own island that it looks at, or
                                       the mouth that looks at it; NONE */
  std::vector<std::size_t> refused; /**< ascending: loops with a line that could have
                                       become a bridge, if it were wanted */
};

/** \brief Of each loop that some bridges lead from the loops that they lead to.
 * \param[in] with_removed those count, too, that are part of no contour (C4.47-3) */
std::map<std::size_t, std::set<std::size_t>>
partnersOver(const SurveyedBridges& joined, bool with_removed);

/** \brief What lines are led by and what they may not run through, built once for all
 * fields; null where it is not needed. */
struct SurveyGuides {
  std::unique_ptr<const Shield> surface;
  std::unique_ptr<const FreePointField> free_points;
};

/** \brief What surveyModel() found. */
struct ModelSurvey {
  IncompleteModel model; /**< islands wound outward as far as that could be told */
  ReadingReport reading;
  std::vector<IslandSide> sides; /**< one an island */
  BoundaryLoops loops;
  std::vector<LoopClass> classes; /**< one a loop */
  MeshFingerprint mesh;           /**< that was read */
  LoopWishes wishes;              /**< about the loops of the input */
  std::set<PointEdge> fin_edges;  /**< of the input, see edgesWithFins() */
  IcmCounts counts;
  IcmClass icm_class = IcmClass::ICM1;
  double facing = 0.0;           /**< of the model when classified, see facingOf() */
  double spacing = 0.0;          /**< mean source spacing, units of the cloud */
  SurveyedField between_islands; /**< step ICM3 -> ICM2 */
  SurveyedBridges joined;
  std::vector<SurveyedField> in_holes;          /**< step ICM2 -> ICM1: complex holes */
  std::shared_ptr<const SurveyGuides> guides;   /**< null where nothing was traced */
  std::shared_ptr<const SightLines> sight;      /**< null where no sensor is known */
  const SurveyParameters* bridged_by = nullptr; /**< by which a look at this model as it
                                                     is has gone; null: none has */
  std::vector<std::pair<std::string, double>> seconds; /**< of each stage */
  bool cancelled = false;
};

/** \brief Tension on a plane through the model, for a picture of the field. */
struct FieldSlice {
  Position corner = Position::Zero();
  Eigen::Vector3d across = Eigen::Vector3d::UnitX(); /**< from one column to the next */
  Eigen::Vector3d up = Eigen::Vector3d::UnitY();     /**< from one row to the next */
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::vector<double> tension; /**< greatest |H n| over all n, row by row */
};

/** \brief Read, orient, classify, trace and choose bridges: everything but triangles.
 * \param[in] free_points a separate cloud of free points, or null
 * \return with reading.problem set when there is no model, or when it is not what the
 * decisions are about */
ModelSurvey
surveyModel(const ccaa::MeshView& mesh,
            const pcl::PCLPointCloud2* free_points,
            const SurveyParameters& parameters,
            const ccaa::LoopContext& context);

/** \brief Diagonal of the bounding box of all triangles. */
double
diagonalOf(const IncompleteModel& model);

/** \brief The field of all islands on the plane through the middle of the model across
 * its shortest extent, in light mode.
 * \param[in] columns of the grid, at least 2; rows follow from the model's shape */
FieldSlice
sliceField(const ModelSurvey& survey,
           const FieldParameters& parameters,
           std::size_t columns,
           const ccaa::LoopContext& context);

} // namespace pcl::repair
