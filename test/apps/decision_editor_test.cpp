// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: decisions by keys, without a window.
#include <gtest/gtest.h>

#include "viewer/decision_editor.h"

namespace app_test {
namespace {

using app::DecisionEditor;
using pcl::repair::Cap;
using pcl::repair::Decisions;
using pcl::repair::LoopWish;

/** Two loops on the x axis, and their junction. */
Decisions
twoLoops()
{
  Decisions decisions;
  decisions.loops.resize(2);
  decisions.loops[0].key.center = {-1.0, 0.0, 0.0};
  decisions.loops[1].key.center = {1.0, 0.0, 0.0};
  decisions.junctions.resize(1);
  decisions.junctions[0].second_loop = 1;
  return decisions;
}

TEST(DecisionEditor, GoesRoundLoopsAndJunctions)
{
  DecisionEditor editor(twoLoops());
  EXPECT_EQ((std::vector<std::size_t>{0}), editor.chosenLoops());
  editor.choosePrevious();
  EXPECT_EQ((std::vector<std::size_t>{0, 1}), editor.chosenLoops());
  editor.chooseNext();
  EXPECT_EQ(0U, editor.chosen());
}

TEST(DecisionEditor, AcceptsAndRejectsLoopsAndJunctions)
{
  DecisionEditor editor(twoLoops());
  editor.accept();
  EXPECT_EQ(LoopWish::CLOSE, editor.decisions().loops[0].wish);
  editor.reject();
  EXPECT_EQ(LoopWish::LEAVE_OPEN, editor.decisions().loops[0].wish);
  editor.choosePrevious();
  editor.reject();
  EXPECT_FALSE(editor.decisions().junctions[0].join);
  editor.accept();
  EXPECT_TRUE(editor.decisions().junctions[0].join);
}

TEST(DecisionEditor, ChangesTheCapOfALoop)
{
  DecisionEditor editor(twoLoops());
  editor.changeCap();
  EXPECT_EQ(Cap::FLAT, editor.decisions().loops[0].cap);
  editor.changeCap();
  EXPECT_EQ(Cap::SMOOTH, editor.decisions().loops[0].cap);
}

TEST(DecisionEditor, UndoesStepByStepAndChoosesWhatWasChanged)
{
  DecisionEditor editor(twoLoops());
  editor.reject();
  editor.chooseNext();
  editor.accept();
  editor.chooseNext();
  EXPECT_TRUE(editor.undo());
  EXPECT_EQ(1U, editor.chosen());
  EXPECT_EQ(LoopWish::AUTO, editor.decisions().loops[1].wish);
  EXPECT_TRUE(editor.undo());
  EXPECT_EQ(LoopWish::AUTO, editor.decisions().loops[0].wish);
  EXPECT_FALSE(editor.undo());
}

TEST(DecisionEditor, KnowsWhetherThereIsSomethingToSave)
{
  DecisionEditor editor(twoLoops());
  editor.chooseNext();
  EXPECT_EQ(0U, editor.unsaved());
  editor.reject();
  editor.changeCap();
  EXPECT_EQ(1U, editor.unsaved());
  editor.chooseNext();
  editor.reject();
  EXPECT_EQ(2U, editor.unsaved());
  editor.setSaved();
  EXPECT_EQ(0U, editor.unsaved());
  editor.undo();
  EXPECT_EQ(1U, editor.unsaved()) << "the junction is another one than in the file";
}

TEST(DecisionEditor, HasNothingToSaveOfWhatIsTakenBackOrDecidedAsBefore)
{
  DecisionEditor editor(twoLoops());
  editor.reject();
  EXPECT_TRUE(editor.undo());
  editor.choosePrevious();
  editor.reject();
  editor.accept();
  EXPECT_EQ(2U, editor.steps());
  EXPECT_EQ(0U, editor.unsaved());
}

TEST(DecisionEditor, HasNothingToDecideOnAClosedSurface)
{
  DecisionEditor editor{Decisions()};
  editor.chooseNext();
  editor.accept();
  EXPECT_EQ(0U, editor.unsaved());
  EXPECT_TRUE(editor.chosenLoops().empty());
}

} // namespace
} // namespace app_test
