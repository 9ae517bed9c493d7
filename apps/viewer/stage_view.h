// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a stage with its legend, as renderers of a window.
#pragma once

#include <Eigen/Core>

#include <vtkPolyData.h>
#include <vtkProp.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include "viewer/light_drawing.h"
#include "viewer/stages.h"
#include "viewer/view_state.h"

#include <string>
#include <utility>
#include <vector>

namespace app {

class Painter;

/** \brief What the camera sees at first. */
struct StageCamera {
  std::vector<Eigen::Vector3d> positions;          /**< what has to be in the picture */
  Eigen::Vector3d view = Eigen::Vector3d::UnitZ(); /**< towards the camera */
  Eigen::Vector3d up = Eigen::Vector3d::UnitY();
};

/** \brief A few letters at a place of the model. */
struct StageLabel {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  std::string text;
};

/** \brief What is drawn over the stages "boundaries" and "holes" while decisions are
 * made. */
struct StageOverlay {
  struct Lines {
    vtkSmartPointer<vtkPolyData> part; /**< with a colour a point */
    double width = 1.0;                /**< pixels */
  };
  std::string note; /**< in place of the stage's text */
  std::vector<Lines> lines;
  std::vector<vtkSmartPointer<vtkPolyData>> faces; /**< with a colour a point */
  std::vector<StageLabel> labels;
};

/** \brief Stages, seen by one camera that stays where it is from stage to stage. */
class StageView {
public:
  /** \param[in] subject name of what is shown, for the legend */
  StageView(std::vector<Stage> stages, StageCamera camera, std::string subject);

  const std::vector<Stage>&
  stages() const
  {
    return stages_;
  }

  /** \brief The model, the legend, and the list of stages; the first of them is always
   * the same one. For a window of this size in pixels. */
  std::vector<vtkSmartPointer<vtkRenderer>>
  arrange(const ViewState& state, int width, int height, bool with_keys);

  /** \brief Back to what the camera saw at first. */
  void
  fit(int width, int height);

  /** \brief To the other side of the model. */
  void
  turnRound();

  /** \brief Draw something over the stages of which it is told, in place of what was
   * there before. */
  void
  setOverlay(const StageOverlay& overlay);

  /** \brief Something to be said below what the legend says; empty: nothing.
   * \return whether there was something before */
  bool
  setMessage(const std::string& text)
  {
    return !std::exchange(message_, text).empty();
  }

  /** \brief Whether there is something to be drawn over the stage that is shown. */
  bool
  showsOverlay(const ViewState& state) const;

  /** \brief Draw the stage that is shown quickly rather than well from now on. Nothing
   * is drawn by this. \return whether anything is so large that it makes a difference
   */
  bool
  drawQuickly(const ViewState& state);

  /** \brief Draw well again. */
  void
  drawWell()
  {
    light_.restore();
  }

  /** \brief The renderer of the model. */
  vtkRenderer&
  model()
  {
    return *model_;
  }

private:
  void
  showParts(const ViewState& state, int height);

  std::vector<Stage> stages_;
  LightDrawing light_;
  StageCamera camera_;
  std::string subject_;
  vtkSmartPointer<vtkRenderer> model_;
  std::string message_;
  std::string note_; /**< of the overlay; empty: there is none */
  std::vector<std::pair<Layer, vtkSmartPointer<vtkProp>>> overlay_;
};

/** \brief A picture of one stage with its legend, for a painter of this size: the bytes
 * of a PNG file; empty when it could not be drawn. */
std::string
drawStage(StageView& view, std::size_t stage, int width, int height, Painter& painter);

} // namespace app
