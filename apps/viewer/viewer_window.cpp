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
#include "viewer/view_state.h"

#include <utility>
#include <vector>

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

class ViewerWindow::Content {
public:
  Content(StageView& view,
          int width,
          int height,
          const std::string& title,
          ScreenshotTaker take)
  : view_(view)
  , state_(view.stages().size())
  , take_(std::move(take))
  , window_(vtkSmartPointer<vtkRenderWindow>::New())
  , style_(vtkSmartPointer<StageStyle>::New())
  {
    style_->on_key = [this](const std::string& key) { act(actionOf(key)); };
    window_->SetMultiSamples(8);
    int no_arguments = 0;
    const vtkSmartPointer<vtkRenderer> model(&view.model());
    viewer_ = std::make_unique<pcl::visualization::PCLVisualizer>(
        no_arguments, nullptr, model, window_, title, style_.Get(), true);
    viewer_->setShowFPS(false);
    viewer_->setSize(width, height);
    viewer_->setWindowName(title);
    view_.fit(width, height);
    show();
  }

  void
  act(const Action& action)
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

  void
  setDesk(DecisionDesk& desk)
  {
    desk_ = &desk;
    show();
  }

  /** \brief Through the interactor, as keys of the keyboard come. */
  void
  press(const std::string& key_symbol)
  {
    vtkRenderWindowInteractor& interactor = *window_->GetInteractor();
    interactor.SetKeySym(key_symbol.c_str());
    interactor.InvokeEvent(vtkCommand::KeyPressEvent);
    interactor.InvokeEvent(vtkCommand::CharEvent);
    interactor.InvokeEvent(vtkCommand::KeyReleaseEvent);
  }

  bool
  update()
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
  picture()
  {
    return encodePng(*window_);
  }

  std::size_t
  stage() const
  {
    return state_.stage();
  }

private:
  /** \brief \return whether a key was about decisions */
  bool
  decide(Command command)
  {
    if (desk_ == nullptr || command != Command::CHOOSE_HERE)
      return desk_ != nullptr && desk_->apply(command);
    const int* const mouse = window_->GetInteractor()->GetEventPosition();
    desk_->chooseAt(mouse[0], mouse[1]);
    return true;
  }

  /** \brief Put the stage and its legend in the window. */
  void
  show()
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

  StageView& view_;
  ViewState state_;
  ScreenshotTaker take_;
  DecisionDesk* desk_ = nullptr;
  vtkSmartPointer<vtkRenderWindow> window_;
  vtkSmartPointer<StageStyle> style_;
  std::unique_ptr<pcl::visualization::PCLVisualizer> viewer_;
  std::vector<vtkSmartPointer<vtkRenderer>> panels_;
  int width_ = 0;
  int height_ = 0;
};

ViewerWindow::ViewerWindow(StageView& view,
                           int width,
                           int height,
                           const std::string& title,
                           ScreenshotTaker take)
: content_(std::make_unique<Content>(view, width, height, title, std::move(take)))
{}

ViewerWindow::~ViewerWindow() = default;

void
ViewerWindow::goTo(std::size_t stage)
{
  Action action;
  action.command = Command::GO_TO_STAGE;
  action.stage = stage;
  content_->act(action);
}

void
ViewerWindow::setDesk(DecisionDesk& desk)
{
  content_->setDesk(desk);
}

void
ViewerWindow::press(const std::string& key_symbol)
{
  content_->press(key_symbol);
}

bool
ViewerWindow::update()
{
  return content_->update();
}

std::size_t
ViewerWindow::stage() const
{
  return content_->stage();
}

std::string
ViewerWindow::picture()
{
  return content_->picture();
}

} // namespace app
