// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: mouse and keys of the viewer, by events of an X server.
#include <gtest/gtest.h>

#include <vtkActorCollection.h>
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkMapper.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>

#include "inspect/inspection_colors.h"
#include "pictures.h"
#include "render/display.h"
#include "repair/decision_proposal.h"
#include "repair_fixture.h"
#include "viewer/decision_desk.h"
#include "viewer/stage_view.h"
#include "viewer/stages.h"
#include "viewer/viewer_window.h"
#include "viewer_events.h"
#include "viewer_fixture.h"
#include "window_button.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace app_test {
namespace {

/** A window with the stage "boundaries" of a mesh: two halves of a sphere. */
class RenderViewerEvents : public WithEvents {
protected:
  explicit RenderViewerEvents(const pcl::PolygonMesh& mesh = twoCaps())
  : run_(runForViewer(mesh))
  {}

  void
  SetUp() override
  {
    WithEvents::SetUp();
    if (IsSkipped() || HasFatalFailure())
      return;
    app::StageCamera camera;
    camera.positions = run_.survey.model.positions;
    camera.view = Eigen::Vector3d::UnitY();
    camera.up = Eigen::Vector3d::UnitZ();
    view_ = std::make_unique<app::StageView>(
        app::makeStages(run_, camera.view), camera, "caps.ply");
    window_ = std::make_unique<app::ViewerWindow>(
        *view_, 700, 500, "caps", app::ScreenshotTaker());
    desk_ = std::make_unique<app::DecisionDesk>(proposeDecisions(run_.survey, {}),
                                                run_.survey,
                                                app::RepairTask(),
                                                *view_,
                                                app::DecisionSavers());
    window_->setDesk(*desk_);
    window_->goTo(1);
  }

  /** Let the X server send events to the window, and answer them. */
  void
  send(const std::string& commands)
  {
    EXPECT_EQ(
        0,
        runInShell("xdotool search --name '^caps$' mousemove --window %1 " + commands)
            .exit_code);
    for (int i = 0; i < 10; ++i)
      window_->update();
  }

  /** Press the button of the window. */
  bool
  staysWhenClosed()
  {
    pressCloseButton(std::stoul(runInShell("xdotool search --name '^caps$'").output));
    bool stays = true;
    for (int i = 0; i < 10 && stays; ++i)
      stays = window_->update();
    return stays;
  }

  /** Where the model shows this colour, from the upper left corner. */
  std::string
  placeOf(const app::Rgb& color)
  {
    const Picture picture = decodePng(window_->picture());
    for (int y = 0; y < picture.height; ++y)
      for (int x = picture.width / 2; x < picture.width; ++x)
        if (picture.pixels[static_cast<std::size_t>(y * picture.width + x)] == color)
          return std::to_string(x) + " " + std::to_string(y);
    ADD_FAILURE() << "the colour is not to be seen";
    return "0 0";
  }

  std::size_t
  chosen() const
  {
    return desk_->editor().chosen();
  }

  app::ViewerRun run_;
  std::unique_ptr<app::StageView> view_;
  std::unique_ptr<app::ViewerWindow> window_;
  std::unique_ptr<app::DecisionDesk> desk_;
};

TEST_F(RenderViewerEvents, AClickPicksALoopOrJunctionAndNothingWhereThereIsNone)
{
  ASSERT_EQ(0U, chosen());
  send(placeOf(app::colorOf(pcl::repair::BoundaryClass::ISLAND_RIM)) + " click 1");
  EXPECT_EQ(1U, chosen());
  send("690 300 click 1");
  EXPECT_EQ(1U, chosen());
  send(placeOf(app::TO_BE_CLOSED) + " click 1");
  EXPECT_EQ(2U, chosen()) << "the line of the junction is picked";
}

TEST_F(RenderViewerEvents, ADragTurnsTheModelAndPicksNothing)
{
  const std::string loop =
      placeOf(app::colorOf(pcl::repair::BoundaryClass::ISLAND_RIM));
  const std::string before = window_->picture();
  send(loop + " mousedown 1 mousemove_relative 40 30 mouseup 1");
  EXPECT_EQ(0U, chosen());
  EXPECT_TRUE(before != window_->picture());
}

TEST_F(RenderViewerEvents, TheResultOfOneRegionIsShownAtOnceAndUndone)
{
  const auto patches = [&] {
    return countShaded(decodePng(window_->picture()),
                       app::colorOf(pcl::TriangleOrigin::COMPLETION));
  };
  ASSERT_EQ(0U, patches());
  send("400 300 key comma v"); // the junction
  const std::size_t joined = patches();
  EXPECT_GT(joined, 1000U);
  send("400 300 key x");
  EXPECT_EQ(0U, patches());
  send("400 300 key u");
  EXPECT_EQ(joined, patches());
  send("400 300 key v");
  EXPECT_EQ(joined, patches()) << "the same again";
}

TEST_F(RenderViewerEvents, KeysOfTheKeyboardDecide)
{
  send("400 300 key x period a");
  EXPECT_EQ(pcl::repair::LoopWish::LEAVE_OPEN,
            desk_->editor().decisions().loops[0].wish);
  EXPECT_EQ(pcl::repair::LoopWish::CLOSE, desk_->editor().decisions().loops[1].wish);
  send("400 300 key u");
  EXPECT_EQ(pcl::repair::LoopWish::AUTO, desk_->editor().decisions().loops[1].wish);
}

TEST_F(RenderViewerEvents, TheButtonOfTheWindowLosesDecisionsOnlyWhenPressedTwice)
{
  send("400 300 key x");
  EXPECT_TRUE(staysWhenClosed());
  send("400 300 key u");
  send("400 300 key x");
  EXPECT_TRUE(staysWhenClosed()) << "other keys came between";
  EXPECT_FALSE(staysWhenClosed());
}

TEST_F(RenderViewerEvents, TheButtonOfTheWindowClosesItWhenNothingWouldBeLost)
{
  send("400 300 key x u");
  EXPECT_FALSE(staysWhenClosed());
}

/** More triangles than are drawn at once, and what has been drawn of them. */
class RenderLargeViewer : public RenderViewerEvents {
protected:
  RenderLargeViewer()
  : RenderViewerEvents(test::toPolygonMesh(test::grid(SIDE + 1, SIDE + 1)))
  {}

  void
  SetUp() override
  {
    RenderViewerEvents::SetUp();
    if (IsSkipped() || HasFatalFailure())
      return;
    const auto command = vtkSmartPointer<vtkCallbackCommand>::New();
    command->SetClientData(this);
    command->SetCallback([](vtkObject*, unsigned long, void* self, void*) {
      auto& drawn = static_cast<RenderLargeViewer*>(self)->drawn_;
      drawn.push_back(static_cast<RenderLargeViewer*>(self)->triangles());
    });
    view_->model().AddObserver(vtkCommand::StartEvent, command);
  }

  /** That the model consists of at present. */
  vtkIdType
  triangles()
  {
    vtkIdType most = 0;
    vtkActorCollection& actors = *view_->model().GetActors();
    actors.InitTraversal();
    while (vtkActor* const actor = actors.GetNextActor())
      if (actor->GetVisibility() != 0)
        if (auto* part = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInput()))
          most = std::max(most, part->GetNumberOfPolys());
    return most;
  }

  /** Whether it comes to that by and by. */
  bool
  isDrawnInFull()
  {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while ((drawn_.empty() || drawn_.back() != ALL) &&
           std::chrono::steady_clock::now() < end)
      window_->update();
    return drawn_.back() == ALL;
  }

  static constexpr int SIDE = 240;
  static constexpr vtkIdType ALL = 2 * SIDE * SIDE;
  std::vector<vtkIdType> drawn_; /**< triangles of each picture */
};

TEST_F(RenderLargeViewer, AKeyIsAnsweredCoarselyAndThenInFull)
{
  ASSERT_TRUE(isDrawnInFull());
  for (const std::string key : {"period", "x", "3", "h"}) {
    drawn_.clear();
    send("400 300 key " + key);
    ASSERT_FALSE(drawn_.empty()) << key;
    EXPECT_LT(drawn_.front(), ALL / 2) << key;
    EXPECT_TRUE(isDrawnInFull()) << key;
  }
}

TEST_F(RenderLargeViewer, KeysThatFollowEachOtherDoNotWaitForAFullPicture)
{
  ASSERT_TRUE(isDrawnInFull());
  drawn_.clear();
  for (const char* const key : {"period", "x", "u", "3", "2", "F12"})
    window_->press(key);
  EXPECT_EQ(5U, drawn_.size());
  EXPECT_LT(*std::max_element(drawn_.begin(), drawn_.end()), ALL / 2);
  EXPECT_TRUE(isDrawnInFull()) << "also after a key without a meaning";
}

TEST_F(RenderLargeViewer, AKeyStopsAFullPictureThatHasBegun)
{
  ASSERT_TRUE(isDrawnInFull());
  window_->press("period");
  bool has_come = false;
  vtkRenderWindow& drawn = *view_->model().GetRenderWindow();
  const auto command = vtkSmartPointer<vtkCallbackCommand>::New();
  command->SetClientData(&has_come);
  command->SetCallback([](vtkObject*, unsigned long, void* come, void*) {
    if (!std::exchange(*static_cast<bool*>(come), true))
      runInShell("xdotool search --name '^caps$' mousemove --window %1 400 300 key x");
  });
  constexpr float FIRST = 1.0F;
  const auto tag = drawn.AddObserver(vtkCommand::AbortCheckEvent, command, FIRST);
  while (!has_come)
    window_->update();
  drawn.RemoveObserver(tag);
  EXPECT_LT(triangles(), ALL / 2);
  drawn_.clear();
  EXPECT_TRUE(isDrawnInFull());
}

TEST_F(RenderLargeViewer, APictureForAFileIsAFullOne)
{
  window_->press("period");
  ASSERT_LT(drawn_.back(), ALL / 2);
  window_->picture();
  EXPECT_EQ(ALL, drawn_.back());
}

} // namespace
} // namespace app_test
