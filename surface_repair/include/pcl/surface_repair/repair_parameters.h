// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: all parameters of a repair.

#pragma once

#include <pcl/surface_repair/darning/darning_method.h>
#include <pcl/surface_repair/extent.h>
#include <pcl/surface_repair/fairing/refinement.h>
#include <pcl/surface_repair/fairing/relaxation.h>
#include <pcl/surface_repair/model_survey.h>

#include <cstddef>
#include <cstdint>

namespace pcl {
namespace repair {

/** \brief How holes are closed. */
enum class DarningChoice : std::uint8_t {
  AUTOMATIC,      /**< COMPLETION where a hole holds enough free points, else
                       MINIMUM_WEIGHT */
  FAN,            /**< from the centroid (4.7), the thesis' baseline */
  MINIMUM_WEIGHT, /**< least largest fold, then least area */
  COMPLETION      /**< base algorithm of surface_ccaa with the free points */
};

/** \brief Which boundaries are closed. */
enum class CloseChoice : std::uint8_t {
  NOTHING, /**< only what joins islands */
  HOLES,   /**< what is a hole for sure */
  ALL /**< also outer borders, mouths of tubes, undecided loops and rims of islands,
           once nothing more can be joined */
};

/** \brief How simple holes are closed, and which. */
struct DarningParameters {
  DarningChoice choice = DarningChoice::AUTOMATIC;
  /** \brief Edges up to which a hole is simple; 0: as many as the method says. */
  std::size_t simple_edges = 0;
  /** \brief Loops of more edges are left open; 0: no limit. */
  std::size_t greatest_hole = 0;
  /** \brief Longer loops are left open; 0: no limit. */
  Extent greatest_length = {};
  CloseChoice close = CloseChoice::HOLES;
  Cap cap = Cap::AUTO; /**< of patches about which no decision says more */
};

/** \brief Everything about a repair that can be set. */
struct RepairParameters {
  SurveyParameters survey; /**< sides, classes, field, lines, bridges */
  DarningParameters darning;
  bool join_islands = true;
  /** \brief A surface without any boundary is wanted: CloseChoice::ALL, and whatever
   * stays open is a shortfall. */
  bool watertight = false;
  bool refine = true;
  bool relax = true; /**< only when refined */
  RefinementParameters refinement;
  RelaxationParameters relaxation; /**< its trust is that of the field */
};

} // namespace repair
} // namespace pcl
