// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the window of the viewer.
#include "viewer/viewer_window.h"

#include <pcl/visualization/pcl_visualizer.h>

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include "render/display.h"
#include "render/drawing.h"
#include "viewer/decision_desk.h"
#include "viewer/stage_view.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

namespace app {
namespace {

/** Milliseconds after which update() returns where nothing happens. */
constexpr int UPDATE_INTERVAL = 20;

/** Of a pixel, for smooth lines. */
constexpr int SAMPLES = 8;

/** After which what has changed is drawn well: keys and turns of a wheel follow each
 * other. */
constexpr std::chrono::milliseconds REST{300};

/** Pixels that a mouse moves in a click, which is no drag yet. */
constexpr int CLICK_REACH = 3;

/** \brief Something is called when an event comes. */
void
observe(vtkObject& object, unsigned long event, std::function<void()> call)
{
  const auto command = vtkSmartPointer<vtkCallbackCommand>::New();
  command->SetClientData(new std::function<void()>(std::move(call)));
  command->SetClientDataDeleteCallback(
      [](void* data) { delete static_cast<std::function<void()>*>(data); });
  command->SetCallback(
      [](vtkObject* /*caller*/,
         unsigned long /*event*/,
         void* data,
         void* /*call_data*/) { (*static_cast<std::function<void()>*>(data))(); });
  object.AddObserver(event, command);
}

/** \brief PCL's mouse with our keys: the latter would do two things at once. */
class StageStyle : public pcl::visualization::PCLVisualizerInteractorStyle {
public:
  std::function<void(const std::string&)> on_key;
  std::function<void(int x, int y)> on_click; /**< pressed and released at one place */

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
  OnLeftButtonDown() override
  {
    std::copy_n(Interactor->GetEventPosition(), 2, pressed_.begin());
    PCLVisualizerInteractorStyle::OnLeftButtonDown();
  }

  void
  OnLeftButtonUp() override
  {
    PCLVisualizerInteractorStyle::OnLeftButtonUp();
    const int* const now = Interactor->GetEventPosition();
    if (on_click && std::abs(now[0] - pressed_[0]) <= CLICK_REACH &&
        std::abs(now[1] - pressed_[1]) <= CLICK_REACH)
      on_click(now[0], now[1]);
  }

  void
  OnKeyUp() override
  {}

  void
  OnChar() override
  {}

private:
  std::array<int, 2> pressed_{}; /**< where the left button went down last */
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
  observe(*style, vtkCommand::StartInteractionEvent, [this] { beginMoving(); });
  observe(*style, vtkCommand::EndInteractionEvent, [this] { changed_ = Clock::now(); });
  style->on_click = [this](int x, int y) { chooseAt(x, y); };
  window_->SetMultiSamples(SAMPLES);
  int no_arguments = 0;
  const vtkSmartPointer<vtkRenderer> model(&view.model());
  viewer_ = std::make_unique<pcl::visualization::PCLVisualizer>(
      no_arguments, nullptr, model, window_, title, style.Get(), true);
  viewer_->setShowFPS(false);
  // The window's own button: PCL would let the interactor end at once.
  window_->GetInteractor()->RemoveObservers(vtkCommand::ExitEvent);
  observe(*window_->GetInteractor(), vtkCommand::ExitEvent, [this] {
    act({Command::QUIT, 0, Layer::SURFACE});
  });
  observe(*window_, vtkCommand::AbortCheckEvent, [this] {
    if (may_stop_ && isAwaited(window_->GetGenericDisplayId()))
      window_->SetAbortRender(1);
  });
  viewer_->setSize(width, height);
  viewer_->setWindowName(title);
  view_.fit(width, height);
  show();
}

ViewerWindow::~ViewerWindow()
{
  desk_ = nullptr; // keys that still wait decide nothing
  // Window and interactor hold each other, and an interactor that was not ended is
  // asked for events by those of later windows.
  const vtkSmartPointer<vtkRenderWindowInteractor> interactor(window_->GetInteractor());
  interactor->TerminateApp();
  interactor->ProcessEvents();
  viewer_.reset();
  window_->SetInteractor(nullptr);
}

void
ViewerWindow::act(const Action& action)
{
  const int* const size = window_->GetSize();
  const bool had_message = view_.setMessage("");
  if (keepsUnsaved(action.command))
    return;
  const bool changed = state_.apply(action) || had_message;
  wants_file_ = wants_file_ || action.command == Command::OPEN_FILE;
  if (action.command == Command::FIT_VIEW)
    view_.fit(size[0], size[1]);
  else if (action.command == Command::OPPOSITE_VIEW)
    view_.turnRound();
  else if (action.command == Command::SCREENSHOT)
    take_(view_.stages()[state_.stage()].name, picture());
  else if (!decide(action.command) && !changed)
    return;
  show();
}

/** What would lose decisions has to come twice, one after the other.
 * \return whether it has come once */
bool
ViewerWindow::keepsUnsaved(Command command)
{
  const Command asked = std::exchange(asked_, Command::NONE);
  if (desk_ == nullptr || command == asked ||
      (command != Command::QUIT && command != Command::OPEN_FILE))
    return false;
  const std::string told = desk_->tellUnsaved(command);
  if (told.empty())
    return false;
  asked_ = command;
  tell(told);
  return true;
}

/** \return whether a key was about decisions */
bool
ViewerWindow::decide(Command command)
{
  if (desk_ == nullptr)
    return false;
  if (command == Command::SAVE_MESH)
    tell("The whole mesh is being repaired.");
  if (command != Command::CHOOSE_HERE)
    return desk_->apply(command);
  const int* const mouse = window_->GetInteractor()->GetEventPosition();
  chooseAt(mouse[0], mouse[1]);
  return false;
}

void
ViewerWindow::chooseAt(int x, int y)
{
  if (desk_ != nullptr && view_.showsOverlay(state_) && desk_->chooseAt(x, y))
    show();
}

void
ViewerWindow::beginMoving()
{
  changed_ = Clock::time_point::max(); // until the mouse lets go
  if (is_quick_)
    return;
  view_.drawQuickly(state_);
  setQuick(true);
}

void
ViewerWindow::setQuick(bool quick)
{
  is_quick_ = quick;
  window_->SetMultiSamples(quick ? 0 : SAMPLES);
}

/** Draw well what was drawn quickly. */
void
ViewerWindow::rest()
{
  if (!is_quick_)
    return;
  view_.drawWell();
  setQuick(false);
  window_->Render();
  if (window_->GetAbortRender() == 0)
    return;
  // The window shows still what was drawn quickly.
  view_.drawQuickly(state_);
  setQuick(true);
  changed_ = Clock::now();
}

/** Put the stage and its legend in the window: at first quickly, where that makes a
 * difference. */
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
  if (view_.drawQuickly(state_))
    setQuick(true);
  window_->Render();
  changed_ = std::max(changed_, Clock::now());
}

void
ViewerWindow::tell(const std::string& text)
{
  view_.setMessage(text);
  show();
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
  // PCL's spinOnce() draws all the time: with millions of triangles nothing else is
  // answered then. VTK's timers miss, and without them it waits for long.
  if (waitForEvents(window_->GetGenericDisplayId(), UPDATE_INTERVAL))
    window_->GetInteractor()->ProcessEvents();
  if (state_.quits())
    return false;
  if (changed_ < Clock::now() - REST) {
    may_stop_ = true;
    rest();
    may_stop_ = false;
  }
  const int* const size = window_->GetSize();
  if (size[0] != width_ || size[1] != height_)
    show();
  return true;
}

std::string
ViewerWindow::picture()
{
  rest();
  return encodePng(*window_);
}

} // namespace app
