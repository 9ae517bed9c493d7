// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a stage with its legend, as renderers of a window.
#include "viewer/stage_view.h"

#include <vtkActor.h>
#include <vtkBillboardTextActor3D.h>
#include <vtkCamera.h>
#include <vtkProperty.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include "render/camera.h"
#include "render/drawing.h"
#include "render/legend.h"

#include <algorithm>
#include <utility>

namespace app {
namespace {

constexpr int OVERLAY_LETTERS = 16; // points

int
stripHeight(int height)
{
  return 2 * letterHeight(height);
}

/** \brief Below the model the names of all stages, the one that is shown dark. */
vtkSmartPointer<vtkRenderer>
makeStrip(const std::vector<Stage>& stages, std::size_t current, int width, int height)
{
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->SetBackground(1.0, 1.0, 1.0);
  const int left = legendWidth(height);
  renderer->SetViewport(static_cast<double>(left) / width,
                        0.0,
                        1.0,
                        static_cast<double>(stripHeight(height)) / height);
  renderer->InteractiveOff();
  // Room for the number, the gap to the next name, and letters wider than half high.
  constexpr std::size_t more_letters = 5;
  std::size_t letters = 0;
  for (const Stage& stage : stages)
    letters += stage.name.size() + more_letters;
  const double letter =
      static_cast<double>(width - left) / static_cast<double>(letters);
  const int size = std::clamp(static_cast<int>(1.6 * letter), 8, letterHeight(height));
  double place = 0.0;
  for (std::size_t i = 0; i < stages.size(); ++i) {
    const std::string name = std::to_string(i + 1) + " " + stages[i].name;
    const auto text =
        makeText(name, static_cast<int>(place), stripHeight(height) * 3 / 4, size);
    place += letter * static_cast<double>(stages[i].name.size() + more_letters);
    vtkTextProperty& property = *text->GetTextProperty();
    if (i == current)
      property.BoldOn();
    else
      property.SetColor(0.6, 0.6, 0.6);
    renderer->AddActor2D(text);
  }
  return renderer;
}

std::vector<LegendNote>
keyNotes(const ViewState& state, bool decides)
{
  std::vector<LegendNote> notes{{"Show or hide", "", false}};
  for (std::size_t i = 0; i < LAYERS; ++i)
    notes.push_back({LAYER_KEYS[i].key,
                     LAYER_KEYS[i].meaning,
                     !state.shows(static_cast<Layer>(i))});
  const auto add = [&](const char* heading, const auto& keys) {
    notes.push_back({heading, "", false});
    for (const KeyHelp& key : keys)
      notes.push_back({key.key, key.meaning, false});
  };
  add("Keys", OTHER_KEYS);
  if (decides)
    add("Decide", DECISION_KEYS);
  return notes;
}

/** \brief Show a surface as its two sides and edges are wanted. */
void
styleSurface(const ViewState& state, vtkActor& surface)
{
  const bool faces = state.shows(Layer::SURFACE);
  const bool edges = state.shows(Layer::EDGES);
  surface.SetVisibility(faces || edges ? 1 : 0);
  for (vtkProperty* const side :
       {surface.GetProperty(), surface.GetBackfaceProperty()}) {
    side->SetEdgeVisibility(faces && edges ? 1 : 0);
    side->SetRepresentation(faces ? VTK_SURFACE : VTK_WIREFRAME);
    side->SetBackfaceCulling(state.shows(Layer::INNER_SIDE) ? 0 : 1);
  }
}

} // namespace

StageView::StageView(std::vector<Stage> stages, StageCamera camera, std::string subject)
: stages_(std::move(stages))
, camera_(std::move(camera))
, subject_(std::move(subject))
, model_(makeRenderer())
{
  for (const Stage& stage : stages_)
    for (const StagePart& part : stage.parts)
      model_->AddActor(part.actor);
}

void
StageView::showParts(const ViewState& state, int height)
{
  for (std::size_t i = 0; i < stages_.size(); ++i)
    for (const StagePart& part : stages_[i].parts) {
      const bool shown = i == state.stage();
      part.actor->SetVisibility(shown && state.shows(part.layer) ? 1 : 0);
      if (shown && part.layer == Layer::SURFACE)
        styleSurface(state, *part.actor);
      const auto size = static_cast<float>(
          std::max(1.0, part.size * state.thickness() * height / 900.0));
      part.actor->GetProperty()->SetLineWidth(part.size > 0.0 ? size : 1.0F);
      part.actor->GetProperty()->SetPointSize(size);
    }
  for (const auto& [layer, prop] : overlay_)
    prop->SetVisibility(showsOverlay(state) && state.shows(layer) ? 1 : 0);
}

bool
StageView::showsOverlay(const ViewState& state) const
{
  const std::string& name = stages_[state.stage()].name;
  return !note_.empty() && (name == "boundaries" || name == "holes");
}

void
StageView::setOverlay(const StageOverlay& overlay)
{
  for (const auto& layer_and_prop : overlay_)
    model_->RemoveViewProp(layer_and_prop.second);
  overlay_.clear();
  note_ = overlay.note;
  for (const StageOverlay::Lines& lines : overlay.lines) {
    auto marks = makeMarks(lines.part, {0.0, 0.0, 0.0}, lines.width);
    showColors(lines.part, *marks);
    overlay_.emplace_back(Layer::LINES, marks);
  }
  for (const auto& part : overlay.faces) {
    auto faces = makeFaces(part, {1.0, 1.0, 1.0}, {1.0, 1.0, 1.0});
    brighten(*faces);
    showColors(part, *faces);
    overlay_.emplace_back(Layer::SURFACE, faces);
  }
  for (const StageLabel& label : overlay.labels) {
    const auto text = vtkSmartPointer<vtkBillboardTextActor3D>::New();
    text->SetInput(label.text.c_str());
    text->SetPosition(label.place.x(), label.place.y(), label.place.z());
    text->GetTextProperty()->SetFontSize(OVERLAY_LETTERS);
    text->GetTextProperty()->SetColor(0.0, 0.0, 0.0);
    text->GetTextProperty()->BoldOn();
    text->GetTextProperty()->SetJustificationToCentered();
    text->GetTextProperty()->SetVerticalJustificationToCentered();
    overlay_.emplace_back(Layer::LINES, text);
  }
  for (const auto& layer_and_prop : overlay_)
    model_->AddViewProp(layer_and_prop.second);
}

std::vector<vtkSmartPointer<vtkRenderer>>
StageView::arrange(const ViewState& state, int width, int height, bool with_keys)
{
  showParts(state, height);
  const Stage& stage = stages_[state.stage()];
  Legend legend;
  legend.title = std::to_string(state.stage() + 1) + "/" +
                 std::to_string(stages_.size()) + " " + stage.title;
  legend.text = showsOverlay(state) ? note_ : stage.text;
  if (!message_.empty())
    legend.text += (legend.text.empty() ? "" : " ") + message_;
  for (const StageColor& color : stage.legend)
    if (state.shows(color.layer))
      legend.entries.push_back(color.entry);
  if (with_keys && state.help())
    legend.notes = keyNotes(state, showsOverlay(state));
  else
    legend.notes = {{subject_, "", false}};
  model_->SetViewport(static_cast<double>(legendWidth(height)) / width,
                      static_cast<double>(stripHeight(height)) / height,
                      1.0,
                      1.0);
  const auto column = makeLegend(legend, width, height);
  column->InteractiveOff();
  return {model_, column, makeStrip(stages_, state.stage(), width, height)};
}

void
StageView::fit(int width, int height)
{
  RenderSettings settings;
  settings.width = std::max(1, width - legendWidth(height));
  settings.height = std::max(1, height - stripHeight(height));
  settings.view = camera_.view;
  settings.up = camera_.up;
  aimCamera(camera_.positions, settings, *model_->GetActiveCamera());
}

bool
StageView::drawQuickly(const ViewState& state)
{
  light_.restore();
  bool is_lighter = false;
  for (const StagePart& part : stages_[state.stage()].parts)
    if (part.actor->GetVisibility() != 0)
      is_lighter = light_.lighten(*part.actor) || is_lighter;
  return is_lighter;
}

void
StageView::turnRound()
{
  model_->GetActiveCamera()->Azimuth(180.0);
  model_->ResetCameraClippingRange();
}

std::string
drawStage(StageView& view, std::size_t stage, int width, int height, Painter& painter)
{
  ViewState state(view.stages().size());
  state.apply({Command::GO_TO_STAGE, stage, Layer::SURFACE});
  view.fit(width, height);
  return painter.draw(view.arrange(state, width, height, false));
}

} // namespace app
