// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: keys of the viewer, with and without its window.
#include <gtest/gtest.h>

#include "inspect/inspection_colors.h"
#include "pictures.h"
#include "render/display.h"
#include "repair/decision_proposal.h"
#include "repair_fixture.h"
#include "viewer/decision_desk.h"
#include "viewer/stage_view.h"
#include "viewer/viewer_window.h"
#include "viewer_fixture.h"

#include <cstdlib>

namespace app_test {
namespace {

using app::Layer;
using app::ViewState;

void
press(const std::string& key, ViewState& state)
{
  state.apply(app::actionOf(key));
}

TEST(ViewState, StepsThroughStagesAndStopsAtTheEnds)
{
  ViewState state(3);
  press("b", state);
  EXPECT_EQ(0U, state.stage());
  press("n", state);
  press("Right", state);
  EXPECT_EQ(2U, state.stage());
  press("space", state);
  EXPECT_EQ(2U, state.stage());
  press("Left", state);
  EXPECT_EQ(1U, state.stage());
}

TEST(ViewState, GoesToAStageByItsNumberIfThereIsOne)
{
  ViewState state(3);
  press("3", state);
  EXPECT_EQ(2U, state.stage());
  press("KP_2", state);
  EXPECT_EQ(1U, state.stage());
  press("4", state);
  EXPECT_EQ(1U, state.stage());
}

TEST(ViewState, TogglesEveryLayerByItsKeyAndKeepsItFromStageToStage)
{
  for (std::size_t i = 0; i < app::LAYERS; ++i) {
    ViewState state(2);
    const auto layer = static_cast<Layer>(i);
    const bool before = state.shows(layer);
    press(app::LAYER_KEYS[i].key, state);
    press("n", state);
    EXPECT_NE(before, state.shows(layer)) << i;
    press(app::LAYER_KEYS[i].key, state);
    EXPECT_EQ(before, state.shows(layer)) << i;
  }
}

TEST(ViewState, TakesCapitalsForSmallLettersAndLeavesOtherKeysAlone)
{
  ViewState state(2);
  press("N", state);
  EXPECT_EQ(1U, state.stage());
  for (const char* key : {"z", "F5", "", "Shift_L", "0"})
    EXPECT_FALSE(state.apply(app::actionOf(key))) << key;
  press("q", state);
  EXPECT_TRUE(state.quits());
}

TEST(ViewState, ThicknessStaysWithinBounds)
{
  ViewState state(1);
  for (int i = 0; i < 100; ++i)
    press("plus", state);
  EXPECT_LE(state.thickness(), 5.0);
  for (int i = 0; i < 100; ++i)
    press("minus", state);
  EXPECT_GT(state.thickness(), 0.1);
}

/** A window on a display of its own, with the stages of two halves of a sphere. */
class RenderViewerWindow : public testing::Test {
protected:
  RenderViewerWindow() { unsetenv("DISPLAY"); }

  app::StageView
  makeView() const
  {
    app::StageCamera camera;
    camera.positions = run_.survey.model.positions;
    camera.view = Eigen::Vector3d::UnitY();
    camera.up = Eigen::Vector3d::UnitZ();
    return {app::makeStages(run_, camera.view), camera, "caps.ply"};
  }

  app::ViewerRun run_ = runForViewer(twoCaps());
};

TEST_F(RenderViewerWindow, ShowsStagesAndLayersAsKeysSay)
{
  const app::Display display;
  ASSERT_TRUE(display.ready());
  app::StageView view = makeView();
  std::vector<std::string> taken;
  app::ViewerWindow window(
      view, 700, 500, "test", [&](const std::string& stage, const std::string& bytes) {
        taken.push_back(stage);
        EXPECT_GT(decodePng(bytes).width, 0);
      });
  const app::Rgb rim = app::colorOf(pcl::repair::BoundaryClass::ISLAND_RIM);
  const auto count = [&] { return countColor(decodePng(window.picture()), rim); };
  EXPECT_EQ(0U, count());
  window.press("n");
  EXPECT_EQ(1U, window.stage());
  const std::size_t shown = count();
  EXPECT_GT(shown, 100U);
  window.press("l");
  EXPECT_EQ(0U, count());
  window.press("l");
  EXPECT_EQ(shown, count());
  window.press("j");
  EXPECT_EQ(std::vector<std::string>{"boundaries"}, taken);
  EXPECT_TRUE(window.update());
  window.press("q");
  EXPECT_FALSE(window.update());
}

TEST_F(RenderViewerWindow, MakesDecisionsByKeysAndSavesThem)
{
  const app::Display display;
  ASSERT_TRUE(display.ready());
  app::StageView view = makeView();
  app::ViewerWindow window(view, 700, 500, "test", {});
  std::vector<pcl::repair::Decisions> saved;
  app::DecisionDesk desk(proposeDecisions(run_.survey, {}),
                         run_.survey,
                         {},
                         view,
                         {[&](const pcl::repair::Decisions& decisions) {
                            saved.push_back(decisions);
                            return app::Written{true, ""};
                          },
                          {}});
  window.setDesk(desk);
  window.press("n");
  const auto count = [&] {
    return countColor(decodePng(window.picture()), app::CHOSEN);
  };
  EXPECT_GT(count(), 100U) << "the chosen loop is to be seen";
  window.press("x");
  window.press("period");
  window.press("period"); // to the junction of both loops
  window.press("x");
  window.press("w");
  window.press("u");
  window.press("w");
  ASSERT_EQ(2U, saved.size());
  EXPECT_EQ(pcl::repair::LoopWish::LEAVE_OPEN, saved[0].loops.at(0).wish);
  EXPECT_FALSE(saved[0].junctions.at(0).join);
  EXPECT_TRUE(saved[1].junctions.at(0).join);
  window.press("b");
  EXPECT_EQ(0U, count()) << "other stages are as they were";
}

TEST_F(RenderViewerWindow, LeavesUnsavedDecisionsOnlyWhenAskedTwice)
{
  const app::Display display;
  ASSERT_TRUE(display.ready());
  app::StageView view = makeView();
  app::ViewerWindow window(view, 700, 500, "test", {});
  bool can_write = false;
  app::DecisionDesk desk(proposeDecisions(run_.survey, {}),
                         run_.survey,
                         {},
                         view,
                         {[&](const pcl::repair::Decisions&) {
                            return app::Written{can_write, ""};
                          },
                          {}});
  window.setDesk(desk);
  window.press("n");
  window.press("f");
  EXPECT_TRUE(window.takeOpenWish()) << "nothing is decided yet";
  window.press("x");
  window.press("period");
  window.press("a");
  EXPECT_EQ("2 decisions are not saved: w saves, q again quits without.",
            desk.tellUnsaved(app::Command::QUIT));
  const std::string before = window.picture();
  window.press("f");
  EXPECT_FALSE(window.takeOpenWish());
  EXPECT_TRUE(before != window.picture()) << "the legend tells";
  window.press("q");
  EXPECT_TRUE(window.update()) << "another question than the first";
  window.press("w"); // fails
  window.press("f");
  EXPECT_FALSE(window.takeOpenWish());
  window.press("f");
  EXPECT_TRUE(window.takeOpenWish());
  window.press("u");
  EXPECT_EQ("1 decision is not saved: w saves, f again opens a file.",
            desk.tellUnsaved(app::Command::OPEN_FILE));
  window.press("u");
  EXPECT_EQ("", desk.tellUnsaved(app::Command::QUIT));
  window.press("x");
  can_write = true;
  window.press("w");
  window.press("q");
  EXPECT_FALSE(window.update()) << "saved";
}

} // namespace
} // namespace app_test
