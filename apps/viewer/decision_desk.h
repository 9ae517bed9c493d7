// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: shows decisions in the viewer, and makes them by its keys.
#pragma once

#include "cli/repair_run.h"
#include "survey/model_survey.h"
#include "viewer/decision_editor.h"
#include "viewer/picking.h"
#include "viewer/stage_view.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace app {

/** \brief How writing a file went. */
struct Written {
  bool done = false;
  std::string told; /**< a sentence */
};

/** \brief Writes decisions, or what comes of them. */
using DecisionSaver = std::function<Written(const pcl::repair::Decisions&)>;

/** \brief What is written by keys. */
struct DecisionSavers {
  DecisionSaver decisions;
  DecisionSaver mesh; /**< that comes of them */
};

/** \brief Between keys, a DecisionEditor and the stages "boundaries" and "holes", in
 * which loops and junctions have their numbers and the colour of what is decided.
 */
class DecisionDesk {
public:
  /** \brief Survey and view have to outlive it. \param[in] task by which the survey
   * was made, for the results of single regions */
  DecisionDesk(pcl::repair::Decisions decisions,
               const pcl::repair::ModelSurvey& survey,
               const RepairTask& task,
               StageView& view,
               DecisionSavers savers);

  /** \brief Do what a key asks for, if it is about decisions. \return whether the
   * picture is another one now */
  bool
  apply(Command command);

  /** \brief What somebody is told who is about to leave: decisions that are not saved.
   * \param[in] command QUIT or OPEN_FILE \return empty where nothing would be lost */
  std::string
  tellUnsaved(Command command) const;

  /** \brief Choose the loop or junction that is seen within a few pixels of a place of
   * the window, in pixels from its lower left corner. Not after the camera has moved
   * without drawing. \return false where there is none: nothing changes */
  bool
  chooseAt(int x, int y);

  const DecisionEditor&
  editor() const
  {
    return editor_;
  }

private:
  /** What has come of single regions: new triangles by what was chosen. */
  using Results = std::map<std::size_t, vtkSmartPointer<vtkPolyData>>;

  std::string
  decide(Command command);
  std::string
  undo();
  std::string
  save();
  void
  hideResult();
  std::string
  showResult();
  std::string
  showResultIfQuick();
  void
  show(const std::string& more = "");
  InspectionLayer
  coloredLoops() const;
  InspectionLayer
  coloredLinks() const;

  DecisionEditor editor_;
  const pcl::repair::ModelSurvey& survey_;
  RepairTask task_;
  StageView& view_;
  DecisionSavers savers_;
  Results results_;             /**< that are shown */
  std::vector<Results> before_; /**< each step of the editor */
  std::vector<PickLine> lines_; /**< of the loops, then of the junctions */
};

} // namespace app
