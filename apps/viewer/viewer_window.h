// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the window of the viewer.
#pragma once

#include <vtkRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>

#include "viewer/view_state.h"

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace pcl {
namespace visualization {
class PCLVisualizer;
}
} // namespace pcl

namespace app {

class DecisionDesk;
class StageView;

/** \brief Takes a picture of a stage, as the bytes of a PNG file. */
using ScreenshotTaker =
    std::function<void(const std::string& stage, const std::string& bytes)>;

/** \brief A pcl::visualization::PCLVisualizer in which keys step through stages. The
 * mouse turns, moves and zooms the model as everywhere in PCL; of PCL's keys none is
 * left but those that mean the same here. */
class ViewerWindow {
public:
  /** \brief Open the window. Needs a display; \a view has to outlive it. */
  ViewerWindow(StageView& view,
               int width,
               int height,
               const std::string& title,
               ScreenshotTaker take);
  ~ViewerWindow();
  ViewerWindow(const ViewerWindow&) = delete;
  ViewerWindow&
  operator=(const ViewerWindow&) = delete;

  /** \brief Let keys make decisions. \a desk has to outlive the window. */
  void
  setDesk(DecisionDesk& desk);

  /** \brief Say something in the legend, until the next key. */
  void
  tell(const std::string& text);

  /** \brief Whether a key has asked for another file since this was called last. */
  bool
  takeOpenWish()
  {
    return std::exchange(wants_file_, false);
  }

  /** \brief Show the stage with this number, from 0. */
  void
  goTo(std::size_t stage);

  /** \brief Do as if this key had been pressed in the window, named as X names it. */
  void
  press(const std::string& key_symbol);

  /** \brief Answer what has happened in the window since the last call.
   * \return false when it was closed or quit by a key: twice, if decisions would be
   * lost */
  bool
  update();

  /** \brief The number of the stage that is shown. */
  std::size_t
  stage() const
  {
    return state_.stage();
  }

  /** \brief What the window shows when nothing happens, as the bytes of a PNG file. */
  std::string
  picture();

private:
  using Clock = std::chrono::steady_clock;

  void
  act(const Action& action);
  bool
  keepsUnsaved(Command command);
  bool
  decide(Command command);
  void
  chooseAt(int x, int y);
  void
  beginMoving();
  void
  setQuick(bool quick);
  void
  rest();
  void
  show();

  StageView& view_;
  ViewState state_;
  ScreenshotTaker take_;
  DecisionDesk* desk_ = nullptr;
  vtkSmartPointer<vtkRenderWindow> window_;
  std::unique_ptr<pcl::visualization::PCLVisualizer> viewer_;
  std::vector<vtkSmartPointer<vtkRenderer>> panels_;
  Command asked_ = Command::NONE; /**< that would lose decisions, if it comes again */
  bool wants_file_ = false;
  bool is_quick_ = false;     /**< the stage is drawn quickly rather than well */
  bool may_stop_ = false;     /**< drawing, when there is something to answer */
  Clock::time_point changed_; /**< when the last change was drawn */
  int width_ = 0;
  int height_ = 0;
};

} // namespace app
