// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: shows decisions in the viewer, and makes them by its keys.
#include "viewer/decision_desk.h"

#include <Eigen/Geometry>

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>

#include "inspect/inspection_colors.h"
#include "inspect/layer_builder.h"
#include "render/mesh_parts.h"
#include "viewer/local_repair.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

namespace app {
namespace {

using pcl::repair::JunctionDecision;
using pcl::repair::LoopDecision;
using pcl::repair::LoopWish;

constexpr double LOOP_WIDTH = 6.0; // pixels
constexpr double LINK_WIDTH = 2.0;
/** Edges of loops whose result is there in the blink of an eye. */
constexpr std::size_t QUICK_EDGES = 300;
constexpr double PICK_REACH = 10.0;
/** Of the depth of the picture: lines lie in the surface. */
constexpr double DEPTH_MARGIN = 0.01;

Rgb
colorOfWish(const LoopDecision& loop)
{
  switch (loop.wish) {
  case LoopWish::CLOSE:
    return TO_BE_CLOSED;
  case LoopWish::LEAVE_OPEN:
    return colorOf(pcl::OpenReason::NOT_WANTED);
  case LoopWish::AUTO:
    break;
  }
  return colorOf(loop.found);
}

Rgb
colorOfWish(const JunctionDecision& junction)
{
  return junction.join ? TO_BE_CLOSED : colorOf(pcl::OpenReason::NOT_WANTED);
}

/** \brief From the centre of one loop to that of the other. */
std::array<Eigen::Vector3d, 2>
linkOf(const pcl::repair::Decisions& decisions, const JunctionDecision& junction)
{
  return {decisions.loops[junction.first_loop].key.center,
          decisions.loops[junction.second_loop].key.center};
}

/** \brief Numbers of loops at their centres, and of junctions between their loops. */
std::vector<StageLabel>
labelsOf(const pcl::repair::Decisions& decisions)
{
  std::vector<StageLabel> labels;
  for (std::size_t k = 0; k < decisions.loops.size(); ++k)
    labels.push_back({decisions.loops[k].key.center, std::to_string(k)});
  for (std::size_t k = 0; k < decisions.junctions.size(); ++k) {
    const auto ends = linkOf(decisions, decisions.junctions[k]);
    labels.push_back({0.5 * (ends[0] + ends[1]), "J" + std::to_string(k)});
  }
  return labels;
}

/** \brief Loops with their numbers, then what links those of a junction. */
std::vector<PickLine>
linesOf(const pcl::repair::Decisions& decisions,
        const pcl::repair::BoundaryLoops& loops)
{
  std::vector<PickLine> lines;
  for (std::size_t k = 0; k < loops.size(); ++k) {
    lines.push_back({k, loops[k].curve.points, true});
    lines.push_back({k, {decisions.loops[k].key.center}, false});
  }
  for (std::size_t k = 0; k < decisions.junctions.size(); ++k) {
    const auto ends = linkOf(decisions, decisions.junctions[k]);
    lines.push_back({loops.size() + k, {ends[0], ends[1]}, false});
  }
  return lines;
}

/** \brief From the model to pixels of its window and the depth that is drawn. */
Eigen::Matrix4d
projectionOf(vtkRenderer& model)
{
  const auto* const composite =
      model.GetActiveCamera()->GetCompositeProjectionTransformMatrix(
          model.GetTiledAspectRatio(), 0.0, 1.0);
  const Eigen::Matrix4d projection =
      Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(
          composite->GetData());
  const int* const size = model.GetSize();
  const int* const origin = model.GetOrigin();
  Eigen::Matrix4d pixels = Eigen::Matrix4d::Identity();
  for (int axis = 0; axis < 2; ++axis) {
    pixels(axis, axis) = 0.5 * size[axis];
    pixels(axis, 3) = origin[axis] + 0.5 * size[axis];
  }
  return pixels * projection;
}

} // namespace

DecisionDesk::DecisionDesk(pcl::repair::Decisions decisions,
                           const pcl::repair::ModelSurvey& survey,
                           const RepairTask& task,
                           StageView& view,
                           DecisionSavers savers)
: editor_(std::move(decisions))
, survey_(survey)
, task_(task)
, view_(view)
, savers_(std::move(savers))
, lines_(linesOf(editor_.decisions(), survey.loops))
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
  case Command::REJECT:
  case Command::CHANGE_CAP:
    more = decide(command);
    break;
  case Command::SHOW_RESULT:
    more = showResult();
    break;
  case Command::UNDO:
    more = undo();
    break;
  case Command::SAVE:
    more = save();
    break;
  case Command::SAVE_MESH:
    more = savers_.mesh(editor_.decisions()).told;
    break;
  default:
    return false;
  }
  show(more);
  return true;
}

std::string
DecisionDesk::decide(Command command)
{
  const std::size_t steps = editor_.steps();
  if (command == Command::ACCEPT)
    editor_.accept();
  else if (command == Command::REJECT)
    editor_.reject();
  else
    editor_.changeCap();
  if (editor_.steps() == steps)
    return "";
  before_.push_back(results_);
  hideResult();
  return command == Command::REJECT ? "" : showResultIfQuick();
}

std::string
DecisionDesk::undo()
{
  if (!editor_.undo())
    return "There is nothing to take back.";
  results_ = std::move(before_.back());
  before_.pop_back();
  return "";
}

std::string
DecisionDesk::save()
{
  const Written written = savers_.decisions(editor_.decisions());
  if (written.done)
    editor_.setSaved();
  return written.told;
}

std::string
DecisionDesk::tellUnsaved(Command command) const
{
  const std::size_t count = editor_.unsaved();
  if (count == 0)
    return "";
  return std::to_string(count) + (count == 1 ? " decision is" : " decisions are") +
         " not saved: w saves, " +
         (command == Command::QUIT ? "q again quits without."
                                   : "f again opens a file.");
}

/** Also of other choices about the same loops. */
void
DecisionDesk::hideResult()
{
  const auto loops = regionOf(editor_.decisions(), editor_.chosen());
  for (auto at = results_.begin(); at != results_.end();) {
    const auto others = regionOf(editor_.decisions(), at->first);
    const bool is_other =
        std::find_first_of(loops.begin(), loops.end(), others.begin(), others.end()) ==
        loops.end();
    at = is_other ? std::next(at) : results_.erase(at);
  }
}

std::string
DecisionDesk::showResult()
{
  if (editor_.size() == 0)
    return "";
  hideResult();
  const LocalRepair local =
      repairLocally(task_, survey_, editor_.decisions(), editor_.chosen());
  if (local.triangles > 0)
    results_[editor_.chosen()] = makePart(local.patches);
  return local.told;
}

std::string
DecisionDesk::showResultIfQuick()
{
  std::size_t edges = 0;
  for (const std::size_t loop : regionOf(editor_.decisions(), editor_.chosen()))
    edges += survey_.loops[loop].vertices.size();
  return edges > QUICK_EDGES ? "v shows the result here." : showResult();
}

bool
DecisionDesk::chooseAt(int x, int y)
{
  vtkRenderer& model = view_.model();
  if (model.IsInViewport(x, y) == 0)
    return false;
  const auto is_hidden = [&](const Eigen::Vector3d& place) {
    const double depth = model.GetZ(static_cast<int>(std::lround(place.x())),
                                    static_cast<int>(std::lround(place.y())));
    return depth < place.z() - DEPTH_MARGIN;
  };
  const auto picked =
      pickNear(lines_, projectionOf(model), {x, y}, PICK_REACH, is_hidden);
  if (picked) {
    editor_.choose(*picked);
    show();
  }
  return picked.has_value();
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
                       is_chosen ? CHOSEN : colorOfWish(editor_.decisions().loops[k]));
    });
  }
  return builder.finish("");
}

InspectionLayer
DecisionDesk::coloredLinks() const
{
  LayerBuilder builder("junctions", "");
  const pcl::repair::Decisions& decisions = editor_.decisions();
  for (std::size_t k = 0; k < decisions.junctions.size(); ++k) {
    const bool is_chosen = editor_.chosen() == decisions.loops.size() + k;
    const auto ends = linkOf(decisions, decisions.junctions[k]);
    builder.addCurve(ends.size(), false, [&](std::size_t i) {
      builder.addPoint(ends[i],
                       is_chosen ? CHOSEN : colorOfWish(decisions.junctions[k]));
    });
  }
  return builder.finish("");
}

void
DecisionDesk::show(const std::string& more)
{
  StageOverlay overlay;
  overlay.note = editor_.tell() + (more.empty() ? "" : " " + more);
  if (editor_.unsaved() > 0)
    overlay.note += " (w writes it)";
  if (!survey_.loops.empty())
    overlay.lines.push_back({makePart(coloredLoops()), LOOP_WIDTH});
  if (!editor_.decisions().junctions.empty())
    overlay.lines.push_back({makePart(coloredLinks()), LINK_WIDTH});
  for (const auto& result : results_)
    overlay.faces.push_back(result.second);
  overlay.labels = labelsOf(editor_.decisions());
  view_.setOverlay(overlay);
}

} // namespace app
