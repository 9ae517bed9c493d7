// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the window of the viewer.
#include "viewer/viewer_window.h"

#include <pcl/visualization/pcl_visualizer.h>

#include <vtkCommand.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include "render/drawing.h"
#include "viewer/decision_desk.h"
#include "viewer/stage_view.h"

#include <utility>

namespace app {
namespace {

/** Milliseconds between two looks at what has happened. */
constexpr int UPDATE_INTERVAL = 20;

/** \brief PCL's mouse with our keys: the latter would do two things at once. */
class StageStyle : public pcl::visualization::PCLVisualizerInteractorStyle {
public:
  std::function<void(const std::string&)> on_key;

  static StageStyle*
  New();

protected:
  void
  OnKeyDown() override
  {
    const char* const symbol = Interactor->GetKeySym();
    if (on_key && symbol != nullptr)
      on_key(symbol);
  }

  void
  OnKeyUp() override
  {}

  void
  OnChar() override
  {}
};

vtkStandardNewMacro(StageStyle);

} // namespace

ViewerWindow::ViewerWindow(StageView& view,
                           int width,
                           int height,
                           const std::string& title,
                           ScreenshotTaker take)
: view_(view)
, state_(view.stages().size())
, take_(std::move(take))
, window_(vtkSmartPointer<vtkRenderWindow>::New())
{
  const auto style = vtkSmartPointer<StageStyle>::New();
  style->on_key = [this](const std::string& key) { act(actionOf(key)); };
  window_->SetMultiSamples(8);
  int no_arguments = 0;
  const vtkSmartPointer<vtkRenderer> model(&view.model());
  viewer_ = std::make_unique<pcl::visualization::PCLVisualizer>(
      no_arguments, nullptr, model, window_, title, style.Get(), true);
  viewer_->setShowFPS(false);
  viewer_->setSize(width, height);
  viewer_->setWindowName(title);
  view_.fit(width, height);
  show();
}

ViewerWindow::~ViewerWindow() = default;

void
ViewerWindow::act(const Action& action)
{
  const int* const size = window_->GetSize();
  const bool changed = state_.apply(action);
  if (action.command == Command::FIT_VIEW)
    view_.fit(size[0], size[1]);
  else if (action.command == Command::OPPOSITE_VIEW)
    view_.turnRound();
  else if (action.command == Command::SCREENSHOT)
    take_(view_.stages()[state_.stage()].name, picture());
  else if (!changed && !decide(action.command))
    return;
  show();
}

/** \return whether a key was about decisions */
bool
ViewerWindow::decide(Command command)
{
  if (desk_ == nullptr || command != Command::CHOOSE_HERE)
    return desk_ != nullptr && desk_->apply(command);
  const int* const mouse = window_->GetInteractor()->GetEventPosition();
  desk_->chooseAt(mouse[0], mouse[1]);
  return true;
}

/** Put the stage and its legend in the window. */
void
ViewerWindow::show()
{
  const int* const size = window_->GetSize();
  width_ = size[0];
  height_ = size[1];
  for (const auto& panel : panels_)
    window_->RemoveRenderer(panel);
  panels_ = view_.arrange(state_, width_, height_, true);
  panels_.erase(panels_.begin()); // the model is in the window for good
  for (const auto& panel : panels_)
    window_->AddRenderer(panel);
  window_->Render();
}

void
ViewerWindow::setDesk(DecisionDesk& desk)
{
  desk_ = &desk;
  show();
}

void
ViewerWindow::goTo(std::size_t stage)
{
  act({Command::GO_TO_STAGE, stage, Layer::SURFACE});
}

/** Through the interactor, as keys of the keyboard come. */
void
ViewerWindow::press(const std::string& key_symbol)
{
  vtkRenderWindowInteractor& interactor = *window_->GetInteractor();
  interactor.SetKeySym(key_symbol.c_str());
  for (const auto event :
       {vtkCommand::KeyPressEvent, vtkCommand::CharEvent, vtkCommand::KeyReleaseEvent})
    interactor.InvokeEvent(event);
}

bool
ViewerWindow::update()
{
  viewer_->spinOnce(UPDATE_INTERVAL);
  if (viewer_->wasStopped() || state_.quits())
    return false;
  const int* const size = window_->GetSize();
  if (size[0] != width_ || size[1] != height_)
    show();
  return true;
}

std::string
ViewerWindow::picture()
{
  return encodePng(*window_);
}

} // namespace app
