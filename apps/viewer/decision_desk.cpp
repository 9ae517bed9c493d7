// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: shows decisions in the viewer, and makes them by its keys.
#include "viewer/decision_desk.h"

#include "inspect/inspection_colors.h"
#include "inspect/layer_builder.h"
#include "render/mesh_parts.h"

#include <algorithm>
#include <utility>

namespace app {
namespace {

using pcl::repair::JunctionDecision;
using pcl::repair::LoopDecision;
using pcl::repair::LoopWish;

Rgb
colorOf(const LoopDecision& loop)
{
  switch (loop.wish) {
  case LoopWish::CLOSE:
    return TO_BE_CLOSED;
  case LoopWish::LEAVE_OPEN:
    return app::colorOf(pcl::OpenReason::NOT_WANTED);
  case LoopWish::AUTO:
    break;
  }
  return app::colorOf(loop.found);
}

/** \brief Numbers of loops at their centres, and of junctions between their loops. */
std::vector<StageLabel>
labelsOf(const pcl::repair::Decisions& decisions)
{
  std::vector<StageLabel> labels;
  for (std::size_t k = 0; k < decisions.loops.size(); ++k)
    labels.push_back({decisions.loops[k].key.center, std::to_string(k)});
  for (std::size_t k = 0; k < decisions.junctions.size(); ++k) {
    const JunctionDecision& junction = decisions.junctions[k];
    labels.push_back({0.5 * (decisions.loops[junction.first_loop].key.center +
                             decisions.loops[junction.second_loop].key.center),
                      "J" + std::to_string(k)});
  }
  return labels;
}

} // namespace

DecisionDesk::DecisionDesk(pcl::repair::Decisions decisions,
                           const pcl::repair::ModelSurvey& survey,
                           StageView& view,
                           DecisionSaver save)
: editor_(std::move(decisions)), survey_(survey), view_(view), save_(std::move(save))
{
  show();
}

bool
DecisionDesk::apply(Command command)
{
  std::string more;
  switch (command) {
  case Command::NEXT_DECISION:
    editor_.chooseNext();
    break;
  case Command::PREVIOUS_DECISION:
    editor_.choosePrevious();
    break;
  case Command::ACCEPT:
    editor_.accept();
    break;
  case Command::REJECT:
    editor_.reject();
    break;
  case Command::CHANGE_CAP:
    editor_.changeCap();
    break;
  case Command::UNDO:
    if (!editor_.undo())
      more = "There is nothing to take back.";
    break;
  case Command::SAVE:
    editor_.setSaved();
    more = save_(editor_.decisions());
    break;
  default:
    return false;
  }
  show(more);
  return true;
}

void
DecisionDesk::chooseAt(int x, int y)
{
  const auto place = [&](double depth) -> Eigen::Vector3d {
    vtkRenderer& model = view_.model();
    model.SetDisplayPoint(x, y, depth);
    model.DisplayToWorld();
    double world[4];
    model.GetWorldPoint(world);
    return Eigen::Vector3d(world[0], world[1], world[2]) / world[3];
  };
  const Eigen::Vector3d from = place(0.0);
  editor_.chooseAlong(from, (place(1.0) - from).normalized());
  show();
}

InspectionLayer
DecisionDesk::coloredLoops() const
{
  LayerBuilder builder("decisions", "");
  const std::vector<std::size_t> chosen = editor_.chosenLoops();
  for (std::size_t k = 0; k < survey_.loops.size(); ++k) {
    const bool is_chosen = std::find(chosen.begin(), chosen.end(), k) != chosen.end();
    const auto& points = survey_.loops[k].curve.points;
    builder.addCurve(points.size(), true, [&](std::size_t i) {
      builder.addPoint(points[i],
                       is_chosen ? CHOSEN : colorOf(editor_.decisions().loops[k]));
    });
  }
  return builder.finish("");
}

void
DecisionDesk::show(const std::string& more)
{
  StageOverlay overlay;
  overlay.note = editor_.tell() + (more.empty() ? "" : " " + more);
  if (editor_.isChanged())
    overlay.note += " (w writes it)";
  if (!survey_.loops.empty())
    overlay.lines = makePart(coloredLoops());
  overlay.labels = labelsOf(editor_.decisions());
  view_.setOverlay(overlay);
}

} // namespace app
