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
#include "viewer/file_dialog.h"
#include "viewer/stage_view.h"
#include "viewer/stages.h"
#include "viewer/viewer_window.h"
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

/** A display that events are sent to. */
class WithEvents : public testing::Test {
protected:
  void
  SetUp() override
  {
    if (runInShell("command -v xdotool").exit_code != 0)
      GTEST_SKIP() << "no xdotool here, which sends events: install it";
    unsetenv("DISPLAY");
    display_ = std::make_unique<app::Display>();
    ASSERT_TRUE(display_->ready());
  }

  std::unique_ptr<app::Display> display_;
};

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

/** The program as a user runs it, on a display of its own. */
class RenderViewerProgram : public WithEvents {
protected:
  void
  SetUp() override
  {
    WithEvents::SetUp();
    save(folder_.path("caps.ply"), twoCaps());
  }

  /** Start it in the folder, do something, and wait for its end. Each step has an end
   * of its own, and a viewer that does not end is killed. */
  RunResult
  runAndDo(const std::string& arguments, const std::string& commands)
  {
    return runInShell(
        "cd " + folder_.path("") + "; pcl_repair_viewer " + arguments +
        " --stage boundaries --size 700x500 & viewer=$!\n"
        "patience() { sleep 100; kill -9 $viewer; }; patience & guard=$!\n" +
        STEPS + commands + "\nwait $viewer; code=$?; kill $guard; exit $code");
  }

  /** Wait for a file; for windows of a name, some at least; move the mouse into one;
   * choose a file in a dialog of that name. What is typed before the dialog has the
   * keyboard ends in a message box of the same name, which Return closes; let the
   * window ask for a file. */
  static constexpr const char* STEPS =
      "lives() { kill -0 $viewer 2>/dev/null; }\n"
      "until_there() { for i in $(seq 600); do { [[ -e $1 ]] || ! lives; } && return; "
      "sleep 0.1; done; }\n"
      "seen() { timeout 20 xdotool search --onlyvisible --name \"$1\" 2>/dev/null; }\n"
      "until_seen() { for i in $(seq 600); do lives || return; "
      "(($(seen \"$1\" | wc -l) >= ${2:-1})) && return; sleep 0.1; done; }\n"
      "until_gone() { for i in $(seq ${2:-600}); do seen \"$1\" >/dev/null && lives || "
      "return 0; sleep 0.1; done; false; }\n"
      "send() { timeout 20 xdotool \"$@\"; }\n"
      "point() { until_seen \"$1\"; "
      "for w in $(seen \"$1\"); do send mousemove --window $w 400 300; done; }\n"
      "choose() { point \"$1\"; for try in $(seq 20); do\n"
      "  send key ctrl+a; send type \"$2\"; send key Return\n"
      "  until_gone \"$1\" 10 && return\n"
      "  for w in $(seen \"$1\"); do send mousemove --window $w 20 20 key Return; "
      "done\n"
      "done; }\n"
      "ask() { for try in $(seq 20); do "
      "point '^pcl_repair_viewer: '; send key f\n"
      "  for i in $(seq 20); do sleep 0.1; seen '^Open a cloud' && return; done; "
      "done; }\n";

  TemporaryFolder folder_;
};

TEST_F(RenderViewerProgram, SavesTheMeshThatARepairMakesWithTheDecisionsSaved)
{
  const RunResult run = runAndDo("caps.ply",
                                 "point '^pcl_repair_viewer: caps'\n"
                                 "send key a period x w\n"
                                 "until_there caps_decisions.json; send key y\n"
                                 "until_there caps_repaired.ply; send key q");
  EXPECT_EQ(0, run.exit_code) << run.errors;
  EXPECT_NE(std::string::npos, run.output.find("Written to caps_repaired.ply. "))
      << run.output;
  const RunResult direct = runApp("pcl_repair_holes",
                                  {folder_.path("caps.ply"),
                                   folder_.path("direct.ply"),
                                   "--decisions",
                                   folder_.path("caps_decisions.json")});
  EXPECT_EQ(2, direct.exit_code) << "half of the surface is new: " << direct.errors;
  EXPECT_TRUE(readFile(folder_.path("direct.ply")) ==
              readFile(folder_.path("caps_repaired.ply")));
  EXPECT_GT(loadMesh(folder_.path("direct.ply")).mesh.polygons.size(),
            twoCaps().polygons.size());
}

TEST_F(RenderViewerProgram, OpensAFileFromADialogAndSaysWhenItCannotBeRead)
{
  if (!app::hasFileDialog())
    GTEST_SKIP() << "built without Qt's widgets";
  writeFile(folder_.path("bad.ply"), "no mesh");
  const std::string caps = folder_.path("caps.ply");
  const RunResult run = runAndDo(
      "",
      "choose '^Open a cloud' " + folder_.path("bad.ply") +
          "\n"
          "choose bad.ply " +
          caps +
          "\n"
          "ask\n"
          "choose '^Open a cloud' " +
          folder_.path("bad.ply") +
          "\n"
          "ask\n"
          "point '^Open a cloud'; send key Escape; until_gone '^Open a cloud'\n"
          "point '^pcl_repair_viewer: '; send key period a w\n"
          "until_there caps_decisions.json; send key q");
  EXPECT_EQ(0, run.exit_code) << run.errors;
  EXPECT_NE(std::string::npos, run.output.find("complete: ")) << run.output;
  EXPECT_FALSE(readFile(folder_.path("caps_decisions.json")).empty());
}

TEST_F(RenderViewerProgram, AsksBeforeItQuitsWithDecisionsThatAreNotSaved)
{
  const RunResult run = runAndDo("caps.ply",
                                 "point '^pcl_repair_viewer: caps'\n"
                                 "send key x f q; sleep 1; send key w\n"
                                 "until_there caps_decisions.json; send key u q q");
  EXPECT_EQ(0, run.exit_code) << run.errors;
  EXPECT_FALSE(readFile(folder_.path("caps_decisions.json")).empty());
}

TEST_F(RenderViewerProgram, EndsWhenNothingIsChosen)
{
  if (!app::hasFileDialog())
    GTEST_SKIP() << "built without Qt's widgets";
  const RunResult run = runAndDo("", "point '^Open a cloud'; send key Escape");
  EXPECT_EQ(0, run.exit_code) << run.errors;
  EXPECT_EQ("complete: nothing was opened\n", run.output);
}

TEST_F(RenderViewerProgram, EndsByASignalWhileADialogIsOpen)
{
  if (!app::hasFileDialog())
    GTEST_SKIP() << "built without Qt's widgets";
  const std::string with_message =
      "point '^Open a cloud'\n"
      "for try in $(seq 20); do send type none; send key Return; sleep 0.5\n"
      "(($(seen '^Open a cloud' | wc -l) == 2)) && break; done; kill $viewer";
  for (const std::string& commands :
       {std::string("point '^Open a cloud'; kill $viewer"), with_message}) {
    const RunResult run = runAndDo("", commands);
    EXPECT_EQ(app::INTERRUPTED, run.exit_code) << run.errors;
    EXPECT_EQ("", run.output);
  }
  const RunResult run = runAndDo("caps.ply",
                                 "ask\n"
                                 "point '^Open a cloud'; kill $viewer");
  EXPECT_EQ(app::INTERRUPTED, run.exit_code) << run.errors;
  EXPECT_EQ(std::vector<std::string>{"caps.ply"}, folder_.names());
}

} // namespace
} // namespace app_test
