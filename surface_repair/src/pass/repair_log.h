// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: writes down what a repair finds and does.

#pragma once

#include <pcl/surface_repair/repair_report.h>

#include "listing/hole_list.h"
#include "survey/model_survey.h"

#include <cstddef>
#include <string>
#include <vector>

namespace pcl::repair {

/** \brief Where triangles of a filling come from, by its name. */
TriangleOrigin
originOf(const std::string& filling);

/** \brief Fills in the report of a repair, step by step. */
class RepairLog {
public:
  /** \brief \param[in] survey what is known at each time: it may change */
  RepairLog(const ModelSurvey& survey, RepairReport& report)
  : survey_(survey), report_(report)
  {}

  /** \brief What came in: islands, loops, class, and its triangles. */
  void
  noteInput();

  /** \brief The time that it took to look at what is there before a pass. */
  void
  noteLook();

  /** \brief Junctions and bridges are those of the present survey from now on. */
  void
  beginPass();

  /** \brief A hole that was closed or is left open, with the bridges that it passes.
   * \return its place in the report */
  std::size_t
  add(const OpenHole& hole, const HoleOutcome& outcome);

  /** \brief So many triangles of the input are no part of the model for a while. */
  void
  leaveOut(std::size_t triangles);
  void
  takeIn(std::size_t triangles);

  /** \brief The next triangle of the output belongs to a closed hole. */
  void
  addTriangle(std::size_t hole);

  /** \brief A free point is a vertex of a closed hole. */
  void
  addFreePoint(std::size_t hole)
  {
    ++report_.holes[hole].free_points;
  }

  /** \brief Time that a step took, added to what it has taken before. */
  void
  countSeconds(const std::string& step, double seconds);

private:
  void
  noteJunctions();
  void
  reportBridges(const OpenHole& hole, const HoleOutcome& outcome, RepairedHole& entry);
  std::size_t
  bridgeEntry(std::size_t bridge);
  pcl::index_t
  pointOf(pcl::index_t vertex) const;

  const ModelSurvey& survey_;
  RepairReport& report_;
  std::size_t pass_ = 0;
  std::vector<std::size_t>
      entry_of_bridge_; /**< of the present survey's bridges, in the report */
};

} // namespace pcl::repair
