// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the viewer as a program, by events of an X server.

#include <gtest/gtest.h>

#include "repair_fixture.h"
#include "viewer/file_dialog.h"
#include "viewer_events.h"

#include <string>

namespace app_test {
namespace {

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
